// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/views/strip_look.h"

#include <array>
#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// The map that gives the flanks of the right segments the means and spreads of those of the left
/// ones; both images show mostly the same. Identity for fewer than ten segments in an image.
Radiometry relative_radiometry(std::span<const EdgeSegment> left,
                               std::span<const EdgeSegment> right);

/// The two sides of a line. A side is absent where its strip leaves one of the images.
struct EdgeLook {
  std::array<std::optional<SideLook>, 2> sides;  ///< left, right of the left segment's direction
  /// Correlation of the mean profiles across the line, -1..1: tells it from parallel lines a few
  /// pixels away, as gutters make them. Absent where the profile leaves one of the images.
  std::optional<double> profile_ncc;
  /// Sides that look_past_wall() has replaced: not of what lies beside the line in both images.
  std::array<bool, 2> is_past_wall{};
};

/// Compares each side of a left segment with the same side of a right one over their epipolar
/// overlap. A side is a plane through the line of an unknown slope (Schmid and Zisserman 1997): the
/// best of level and 35 degrees up or down counts. Judging each side by itself tolerates that the
/// other one is occluded, which is the rule at eaves.
/// @param transfer  of the left image to the right one, near the segment
EdgeLook edge_look(const ImagePair& images,
                   const EdgePair& edges,
                   const LocalTransfer& transfer,
                   const StripGrid& grid = {});

}  // namespace ridgeline::reconstruct
