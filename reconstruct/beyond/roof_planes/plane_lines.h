// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"
#include "reconstruct/views/scene.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Method::kPlanes: ridges, hips and valleys where two plane faces of the surface meet and no line was reconstructed from
/// edges. A line runs as far as the faces border on each other along it; its covariance is that of both planes.
/// @param known  lines from edges; a line that they run along, to 0.3 m, over half of its length is left out
/// In the order of the faces. Status kPlanes, no match.
std::vector<ReconstructedLine> plane_lines(const StereoPair& pair,
                                           const Surface& surface,
                                           std::span<const ReconstructedLine> known,
                                           double max_aligned_angle_deg);

}  // namespace ridgeline::reconstruct
