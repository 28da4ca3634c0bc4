// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// The options of pair-wise matching. Ok et al. 2011 name the steps but publish no numbers, so the
/// defaults are ours.
struct MatchOptions {
  double first_pair_radius_px = 30.0;  ///< the radius grows until a segment has min_partners
  double max_pair_radius_px = 150.0;
  int min_partners = 3;
  int max_partners = 15;
  double min_pair_angle_deg = 10.0;  ///< smallest enclosed angle, as in the t-term of Eq. 6
  /// Largest difference of a pair's enclosed angle between the images, up to a base to height ratio
  /// of 0.26. Beyond that ratio it grows in proportion.
  double max_pair_turn_deg = 15.0;
  double max_pair_epipolar_px = 5.0;

  /// Largest ratio of the probabilities of the next and the best mate.
  double max_distance_ratio = 0.8;
  /// Least probability of a match against its rivals. It is 0.9 if a segment is shorter than 12 px,
  /// and 0.6 if one segment is shorter than three quarters of the other.
  double min_probability = 0.4;
  /// Least votes from the pairs of a match whose partners are matched.
  double min_votes = 0.3;
  /// Least probability of a match without matched partners, where only its look tells.
  double min_isolated_probability = 0.98;

  static constexpr auto fields() {
    using O = MatchOptions;
    return std::tuple{
        Field{"first_pair_radius_px", &O::first_pair_radius_px, 1.0, 1e4,
              "initial search radius of line pairs"},
        Field{"max_pair_radius_px", &O::max_pair_radius_px, 1.0, 1e4,
              "maximum search radius for a segment with few partners"},
        Field{"min_partners", &O::min_partners, 1, 1000,
              "number of partners at which the radius stops growing"},
        Field{"max_partners", &O::max_partners, 1, 1000,
              "maximum number of nearest partners per segment"},
        Field{"min_pair_angle_deg", &O::min_pair_angle_deg, 0.1, 89.0,
              "minimum angle between the lines of a pair"},
        Field{"max_pair_turn_deg", &O::max_pair_turn_deg, 0.0, 90.0,
              "maximum difference of this angle between the images; grows in proportion above a "
              "base-to-height ratio of 0.26"},
        Field{"max_pair_epipolar_px", &O::max_pair_epipolar_px, 0.0, 100.0,
              "maximum distance of the intersection of a pair from its epipolar line"},
        Field{"max_distance_ratio", &O::max_distance_ratio, 0.0, 1.0,
              "maximum probability ratio of the second-best and best candidates; above, the line "
              "is ambiguous"},
        Field{"min_probability", &O::min_probability, 0.0, 1.0, "minimum probability of a match"},
        Field{"min_votes", &O::min_votes, 0.0, 100.0,
              "minimum votes from pairs for a match with matched partners"},
        Field{"min_isolated_probability", &O::min_isolated_probability, 0.0, 1.0,
              "minimum probability of a match without matched partners"}};
  }
};

}  // namespace ridgeline::reconstruct
