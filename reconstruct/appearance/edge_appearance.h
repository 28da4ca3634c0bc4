// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/strip_appearance.h"

#include <array>
#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// The radiometric mapping that gives the flanks of the right segments the same mean and spread as
/// those of the left ones, because both images mostly show the same objects. It is the identity if
/// an image has fewer than ten segments.
Radiometry relative_radiometry(std::span<const EdgeSegment> left,
                               std::span<const EdgeSegment> right);

/// The two sides of a line. A side is absent if its strip leaves one of the images.
struct EdgeAppearance {
  std::array<std::optional<SideAppearance>, 2> sides;  ///< left and right of the left segment
  /// Correlation of the mean profiles across the line, -1..1. It distinguishes the line from
  /// parallel lines a few pixels away, such as those of gutters. Absent if the profile leaves one
  /// of the images.
  std::optional<double> profile_ncc;
  /// Sides replaced by appearance_past_wall(). They do not compare the areas next to the line in
  /// both images.
  std::array<bool, 2> is_past_wall{};
};

/// Compares each side of a left segment with the same side of a right one over their epipolar
/// overlap. A side is a plane of unknown slope through the line (Schmid and Zisserman 1997), so the
/// best result of a level side and of sides sloping 35 degrees up or down is used. Because each
/// side is judged separately, the other one may be occluded, as is usual at eaves.
/// @param transfer  from the left image to the right one, near the segment
EdgeAppearance edge_appearance(const ImagePair& images,
                               const EdgePair& edges,
                               const LocalTransfer& transfer,
                               const StripGrid& grid = {});

}  // namespace ridgeline::reconstruct
