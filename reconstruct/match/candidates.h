// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/line_similarity.h"
#include "reconstruct/match/match_view.h"
#include "reconstruct/match/options.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ridgeline::reconstruct {

/// A right segment that may be the mate of a left one.
struct Candidate {
  int right = 0;
  EpipolarOverlap overlap;
  EdgeLook look;
  LineMeasures measures;    ///< from the look and the geometry
  double similarity = 0.0;  ///< of the single lines, in [0, 1]
};

/// The candidates of each left segment: right segments that overlap its epipolar band for the range
/// of heights, at a direction and a height that can be; the best `max_candidates` by the look of
/// the single line, best first.
std::vector<std::vector<Candidate>> match_candidates(const MatchView& left,
                                                     const MatchView& right,
                                                     const StereoSearch& search,
                                                     const Radiometry& radiometry,
                                                     const MatchOptions& options);

}  // namespace ridgeline::reconstruct
