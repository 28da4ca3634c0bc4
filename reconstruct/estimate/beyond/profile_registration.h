// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/scene/scene.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// How the colour profiles across the two edges of a match compare.
struct ComparedProfiles {
  /// How far beside the right segment the right image shows what lies under the left one, in pixels
  /// along n =
  /// (-u_y, u_x). 0 if the profiles agree as well where they are, or agree nowhere.
  double right_shift_px = 0.0;
  /// Correlation of the profiles where the right segment is, or is moved to; 1 for the same
  /// profile. Nothing if the profiles were not compared.
  std::optional<double> similarity;
};

/// Compares the colour profiles across the two edges of each match. An edge may have been found at
/// one border of a road marking in one image and at the other border in the other image, or at
/// neither. If both images show both surfaces beside a line, the profiles across it are the same
/// and tell the shift (area-based matching, reduced to the one direction that a line fixes). The
/// result has one element per match. Matches at an angle of up to `max_angle_deg` to the epipolar
/// line, without overlap or too near to the border are not compared. Throws std::invalid_argument
/// for other numbers of bands, std::out_of_range for an index that no segment has.
std::vector<ComparedProfiles> compare_profiles(const StereoPair& pair,
                                               std::span<const Correspondence> matches,
                                               double max_angle_deg);

}  // namespace ridgeline::reconstruct
