// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/edge_appearance.h"

namespace ridgeline::reconstruct {

/// Searches beyond a wall for the less similar side of an edge, if this side may lie lower than the
/// edge, like the ground beside a roof. The camera that faces the wall sees the wall beside the
/// edge, and the ground beyond the wall. The other camera sees the ground beside the edge. So the
/// strip beside the edge in one image is compared with strips farther out in the other image, up to
/// 36 px, each for a height of a level surface below the edge. The choice among many heights makes
/// the best strip more similar by chance; this gain is subtracted. If the best strip is still more
/// similar than the side, it replaces the side. Nothing changes if a side is not visible, or if
/// both sides agree.
/// @param appearance   of the line; its less similar side is replaced
/// @param transfer     from the left image to the right one, near the segment
/// @param most_drop_m  how far below the line the surface may lie
void appearance_past_wall(const ImagePair& images,
                          const EdgePair& edges,
                          const LocalTransfer& transfer,
                          double most_drop_m,
                          EdgeAppearance& appearance);

}  // namespace ridgeline::reconstruct
