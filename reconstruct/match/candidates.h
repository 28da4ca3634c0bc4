// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/line_similarity.h"
#include "reconstruct/geometry/field.h"
#include "reconstruct/scene/scene.h"

#include <functional>
#include <tuple>
#include <vector>

namespace ridgeline::reconstruct {

/// The end points of a segment closer to the epipolar direction than this are not transferred by
/// geometry. Our own value.
inline constexpr double kMinEpipolarAngle_deg = 5.0;
/// Number of candidates kept per segment: those that are most similar as single lines.
inline constexpr int kMaxCandidates = 8;
/// Minimum epipolar overlap of two segments, as a share of the shorter one. Our own value.
inline constexpr double kMinEpipolarOverlap = 0.3;

/// Limits on the right segments that may be the counterpart of a left one.
struct CandidateOptions {
  double max_turn_deg = 35.0;   ///< a steep roof line turns by up to 20 degrees between views
  double max_slope_deg = 50.0;  ///< largest roof slope; a match with a steeper line is wrong

  static constexpr auto fields() {
    using O = CandidateOptions;
    return std::tuple{
        Field{"max_turn_deg", &O::max_turn_deg, 0.0, 90.0,
              "maximum difference in direction of two matched segments"},
        Field{"max_slope_deg", &O::max_slope_deg, 0.0, 89.9,
              "maximum slope of a line in object space; 89.9 includes vertical edges of walls"}};
  }
};

/// A right segment that may be the counterpart of a left one.
struct Candidate {
  int right = 0;
  EpipolarOverlap overlap;
  EdgeAppearance appearance;
  LineMeasures measures;    ///< from the appearance and the geometry
  double similarity = 0.0;  ///< line_similarity() of the measures, in [0, 1]
  double log_odds = 0.0;    ///< log odds that extensions beyond the paper add to the votes
};

/// The candidates of each left segment, best first.
using Candidates = std::vector<std::vector<Candidate>>;

/// Changes the appearance of a candidate that is not near-aligned; the hook for extensions beyond
/// the paper. May be empty. `most_drop_m`: height of the lower end of the line above the lowest
/// object height.
using CandidateAppearance = std::function<void(const ImagePair& images,
                                               const EdgePair& edges,
                                               const LocalTransfer& transfer,
                                               double most_drop_m,
                                               EdgeAppearance& appearance)>;

/// The candidates of each left segment: right segments that overlap its epipolar band over the
/// height range and whose direction and height are possible. Compared as single lines, the
/// `max_candidates` most similar ones are kept, best first. Throws std::invalid_argument for
/// options out of range.
Candidates match_candidates(const SearchedPair& pair,
                            const Radiometry& radiometry,
                            const CandidateOptions& options,
                            const CandidateAppearance& change_appearance = {},
                            int max_candidates = kMaxCandidates);

}  // namespace ridgeline::reconstruct
