// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::reconstruct {

/// The options of pair-wise matching. Ok et al. 2011 name the steps but publish no numbers, so the
/// defaults are ours.
struct MatchOptions {
  /// Minimum probability of a match relative to its rivals; at least 0.9 if a segment is shorter
  /// than 12 px, and 0.6 if one segment is shorter than three quarters of the other.
  double min_probability = 0.4;
  /// Minimum votes from the pairs of a match whose partners are matched.
  double min_votes = 0.3;

  static constexpr auto fields() {
    using O = MatchOptions;
    return std::tuple{
        Field{"min_probability", &O::min_probability, 0.0, 1.0, "minimum probability of a match"},
        Field{"min_votes", &O::min_votes, 0.0, 100.0,
              "minimum votes from pairs for a match with matched partners"}};
  }
};

}  // namespace ridgeline::reconstruct
