// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/line_match.h"
#include "reconstruct/views/scene.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// How the colour profiles across the two edges of a match compare.
struct ComparedProfiles {
  /// How far beside the right segment the right image shows what the left one lies on, pixels along
  /// n = (-u_y, u_x); 0 where the profiles agree as well as they are, or nowhere.
  double right_shift_px = 0.0;
  /// Where the right segment is, or is moved to: correlation, 1 for the same profile. None where they were
  /// not compared.
  std::optional<double> similarity;
};

/// Compares the profiles of each match: an edge may have been found at one border of a road marking in one image and at the other border
/// in the other one, or at neither. Where both images show both surfaces beside a line, the colour
/// profiles across it are the same and tell (area-based matching, reduced to the one direction that a
/// line fixes). By match; those up to `max_angle_deg` to the epipolar line, without overlap or too near
/// to the border are not compared.
/// Throws std::invalid_argument for other numbers of bands, std::out_of_range for an index that no
/// segment has.
std::vector<ComparedProfiles> compare_profiles(const StereoPair& pair,
                                               std::span<const LineMatch> matches,
                                               double max_angle_deg);

}  // namespace ridgeline::reconstruct
