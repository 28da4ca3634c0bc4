// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/scene/scene.h"
#include "reconstruct/surface/surface.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Ridges, hips and valleys where two plane faces of the surface meet and no line was reconstructed
/// from edges (Method::kPlanes). A line runs as far as the faces border on each other along it. Its
/// covariance follows from those of both planes.
/// @param known  lines from edges; an intersection line along which they run, to within 0.3 m, over
///               half of its length is left out
/// The lines are in the order of the faces. Their status is kPlanes. They are observed in views 0
/// and 1 (left, right), without a segment (-1).
std::vector<ReconstructedLine> plane_lines(const StereoPair& pair,
                                           const Surface& surface,
                                           std::span<const ReconstructedLine> known,
                                           double max_aligned_angle_deg);

}  // namespace ridgeline::reconstruct
