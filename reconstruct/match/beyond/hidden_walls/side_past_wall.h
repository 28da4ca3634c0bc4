// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/edge_appearance.h"

namespace ridgeline::reconstruct {

/// Looks for the worse side of an edge past a wall, if this side may lie lower than the edge, as
/// the ground beside a roof does. The camera that faces the wall sees the wall beside the edge, and
/// the ground beyond the wall. The other camera sees the ground beside the edge. So the strip
/// beside the edge in one image is compared with strips farther out in the other image, up to 36
/// px, each for a height of a level surface below the edge. The choice among many heights makes the
/// best strip more similar by chance; this gain is taken off. If the best strip is still more
/// similar than the side, it replaces the side. Nothing changes if a side is not seen, or if both
/// sides agree.
/// @param look         the appearance of the line; its worse side is replaced
/// @param transfer     from the left image to the right one, near the segment
/// @param most_drop_m  how far below the line the surface may lie
void appearance_past_wall(const ImagePair& images,
                          const EdgePair& edges,
                          const LocalTransfer& transfer,
                          double most_drop_m,
                          EdgeAppearance& appearance);

}  // namespace ridgeline::reconstruct
