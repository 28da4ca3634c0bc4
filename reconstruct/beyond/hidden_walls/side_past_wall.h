// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/views/edge_look.h"

namespace ridgeline::reconstruct {

/// How the worse side of an edge looks if it lies lower than the edge, as the ground beside a roof
/// does. The camera that faces the wall sees the wall beside the edge, and that ground beyond it; the
/// other camera sees the ground beside the edge. So the strip beside the edge in one image is compared
/// with strips farther out in the other one, up to 36 px: each for a height of a level surface below the
/// edge. The best one replaces the side if it is more similar even without what the choice among many
/// heights gains by chance, which is taken off. Nothing changes where a side is not seen, or both agree.
/// @param look      of the line; its worse side is replaced
/// @param transfer  of the left image to the right one, near the segment
/// @param most_drop_m  below the line that the surface may lie
void look_past_wall(const ImagePair& images,
                    const EdgePair& edges,
                    const LocalTransfer& transfer,
                    double most_drop_m,
                    EdgeLook& look);

}  // namespace ridgeline::reconstruct
