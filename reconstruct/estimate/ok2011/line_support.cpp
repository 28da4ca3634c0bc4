// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/line_support.h"

#include "reconstruct/geometry/transformed.h"

namespace ridgeline::reconstruct {

std::vector<CandidatePoint> best_of_regions(std::span<const CandidatePoint> candidates) {
  const std::vector<RankedPoint> ranked = transformed(candidates, &CandidatePoint::ranked);
  return transformed(select_points(ranked), [&](std::size_t i) { return candidates[i]; });
}

LineSupport published_support(const TrackedLines& lines,
                              const ObservedTrack& line,
                              std::span<const int> neighbours) {
  LineSupport support;
  support.track = line;
  support.points = best_of_regions(candidate_points(lines, line, neighbours));
  return support;
}

}  // namespace ridgeline::reconstruct
