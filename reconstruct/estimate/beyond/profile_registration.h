// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/scene/scene.h"

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Comparison of the colour profiles across the two edges of a match.
struct ComparedProfiles {
  /// Offset from the right segment at which the right image shows what lies under the left one, in
  /// pixels along n = (-u_y, u_x). 0 if the profiles agree equally well without a shift, or agree
  /// nowhere.
  double right_shift_px = 0.0;
  /// Correlation of the profiles at the right segment, after any shift; 1 for identical profiles.
  /// Empty if the profiles were not compared.
  std::optional<double> similarity;
};

/// Compares the colour profiles across the two edges of each match. An edge may have been found at
/// one border of a road marking in one image and at the other border in the other image, or at
/// neither. If both images show both surfaces beside a line, the profiles across it are the same
/// and determine the shift (area-based matching, reduced to the one direction that a line fixes).
/// The result has one element per match. Matches at an angle of up to `max_angle_deg` to the
/// epipolar line, without overlap or too close to the border are not compared. Throws
/// std::invalid_argument for different numbers of bands and std::out_of_range for an index without
/// a segment.
std::vector<ComparedProfiles> compare_profiles(const StereoPair& pair,
                                               std::span<const Correspondence> matches,
                                               double max_angle_deg);

}  // namespace ridgeline::reconstruct
