// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"

#include <array>

namespace ridgeline::reconstruct {

/// The flanks of a right segment on the left and the right of its left mate's direction.
/// @param reversed  the right segment runs against the left one, so that its flanks change sides
inline std::array<const Flank*, 2> mate_flanks(const EdgeSegment& right, bool reversed) {
  if (reversed) return {&right.right, &right.left};
  return {&right.left, &right.right};
}

}  // namespace ridgeline::reconstruct
