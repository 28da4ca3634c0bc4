// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/match/line_similarity.h"
#include "reconstruct/ok2011/match/options.h"
#include "reconstruct/views/match_view.h"

#include <array>
#include <cstdint>
#include <functional>
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

/// Changes the look of a match that is not near-aligned: where what goes beyond the paper enters. May be empty.
/// `most_drop_m`: from the lower end of the line to the lowest height.
using CandidateLook = std::function<void(const ImagePair& images,
                                         const EdgeSegment& left,
                                         const EdgeSegment& right,
                                         const EpipolarOverlap& overlap,
                                         const LocalTransfer& transfer,
                                         double most_drop_m,
                                         EdgeLook& look)>;

/// The candidates of each left segment: right segments that overlap its epipolar band for the range
/// of heights, at a direction and a height that can be; the best `max_candidates` by the look of
/// the single line, best first.
std::vector<std::vector<Candidate>> match_candidates(const MatchView& left,
                                                     const MatchView& right,
                                                     const StereoSearch& search,
                                                     const Radiometry& radiometry,
                                                     const MatchOptions& options,
                                                     const CandidateLook& change_look = {});

}  // namespace ridgeline::reconstruct
