// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"
#include "reconstruct/views/line_similarity.h"
#include "reconstruct/views/scene.h"

#include <functional>
#include <tuple>
#include <vector>

namespace ridgeline::reconstruct {

/// Which right segments may be the mate of a left one.
struct CandidateOptions {
  /// Below this angle to the epipolar line end points are not transferred by geometry.
  double min_epipolar_angle_deg = 5.0;
  double max_turn_deg = 35.0;   ///< a steep line of a roof turns by up to 20 degrees between views
  double max_slope_deg = 50.0;  ///< of a roof; where it implies more, a match is wrong
  double epipolar_tolerance_px = 2.0;  ///< of near-aligned segments to each other's epipolar band
  double min_overlap = 0.3;            ///< of the shorter segment, in the epipolar overlap
  int max_candidates = 8;              ///< per segment, by the look of the single line

  static constexpr auto fields() {
    using O = CandidateOptions;
    return std::tuple{
        Field{"min_epipolar_angle_deg", &O::min_epipolar_angle_deg, 0.1, 45.0,
              "below this angle to the epipolar line the look decides what corresponds"},
        Field{"max_turn_deg", &O::max_turn_deg, 0.0, 90.0,
              "largest difference of direction of two matched segments"},
        Field{"max_slope_deg", &O::max_slope_deg, 0.0, 89.9,
              "largest slope of a line in object space; 89.9 for edges of walls too"},
        Field{"epipolar_tolerance_px", &O::epipolar_tolerance_px, 0.0, 100.0,
              "of near-aligned segments to each other's epipolar band"},
        Field{"min_overlap", &O::min_overlap, 0.0, 1.0,
              "epipolar overlap of two segments, share of the shorter one"},
        Field{"max_candidates", &O::max_candidates, 1, 100, "candidates kept per segment"}};
  }
};

/// A right segment that may be the mate of a left one.
struct Candidate {
  int right = 0;
  EpipolarOverlap overlap;
  EdgeLook look;
  LineMeasures measures;    ///< from the look and the geometry
  double similarity = 0.0;  ///< of the single lines, in [0, 1]
  double log_odds = 0.0;    ///< that what goes beyond the paper adds to the votes
};

/// By left segment, best first.
using Candidates = std::vector<std::vector<Candidate>>;

/// Changes the look of a match that is not near-aligned: where what goes beyond the paper enters. May be empty.
/// `most_drop_m`: from the lower end of the line to the lowest height.
using CandidateLook = std::function<void(const ImagePair& images,
                                         const EdgePair& edges,
                                         const LocalTransfer& transfer,
                                         double most_drop_m,
                                         EdgeLook& look)>;

/// The candidates of each left segment: right segments that overlap its epipolar band for the range
/// of heights, at a direction and a height that can be; the best `max_candidates` by the look of
/// the single line, best first. Throws std::invalid_argument for options out of range.
Candidates match_candidates(const SearchedPair& pair,
                            const Radiometry& radiometry,
                            const CandidateOptions& options,
                            const CandidateLook& change_look = {});

}  // namespace ridgeline::reconstruct
