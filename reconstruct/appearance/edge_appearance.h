// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/strip_appearance.h"

#include <array>
#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// The map that gives the flanks of the right segments the means and spreads of the flanks of the
/// left ones, as both images show mostly the same. It is the identity for fewer than ten segments
/// in an image.
Radiometry relative_radiometry(std::span<const EdgeSegment> left,
                               std::span<const EdgeSegment> right);

/// The two sides of a line. A side is absent where its strip leaves one of the images.
struct EdgeAppearance {
  std::array<std::optional<SideAppearance>, 2>
      sides;  ///< left, right of the left segment's direction
  /// Correlation of the mean profiles across the line, -1..1. It tells the line from parallel lines
  /// a few pixels away, such as those of gutters. Absent if the profile leaves one of the images.
  std::optional<double> profile_ncc;
  /// Sides that appearance_past_wall() has replaced. They do not compare what lies beside the line
  /// in both images.
  std::array<bool, 2> is_past_wall{};
};

/// Compares each side of a left segment with the same side of a right one over their epipolar
/// overlap. A side is a plane of unknown slope through the line (Schmid and Zisserman 1997), so the
/// best result of a level side and of 35 degrees up or down counts. Judging each side by itself
/// tolerates that the other one is occluded, which is the rule at eaves.
/// @param transfer  from the left image to the right one, near the segment
EdgeAppearance edge_appearance(const ImagePair& images,
                               const EdgePair& edges,
                               const LocalTransfer& transfer,
                               const StripGrid& grid = {});

}  // namespace ridgeline::reconstruct
