// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/estimate/line_support.h"

namespace ridgeline::reconstruct {

std::vector<CandidatePoint> best_of_regions(std::span<const CandidatePoint> candidates,
                                            const ReconstructOptions& options) {
  std::vector<RankedPoint> ranked;
  ranked.reserve(candidates.size());
  for (const CandidatePoint& candidate : candidates) ranked.push_back(candidate.ranked);
  std::vector<CandidatePoint> selected;
  for (const std::size_t i : select_points(ranked, options)) selected.push_back(candidates[i]);
  return selected;
}

LineSupport published_support(const StereoLines& lines,
                              const ObservedPair& line,
                              std::span<const int> neighbours,
                              const ReconstructOptions& options) {
  LineSupport support;
  support.seen = line;
  support.points = best_of_regions(candidate_points(lines, line, neighbours, options), options);
  return support;
}

}  // namespace ridgeline::reconstruct
