// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"

#include <vector>

namespace ridgeline::reconstruct {

/// The segments of View::own_segments, in their order, completed from the view: the line in ideal
/// pixels, the flanks and the direction. Segments are left out if an end lies where the distortion
/// of the lens is unknown, or if remove_edges_of_no_data() removes them.
/// @param view  its image comes from normalised(); it has own segments
std::vector<EdgeSegment> completed_own_segments(const View& view);

}  // namespace ridgeline::reconstruct
