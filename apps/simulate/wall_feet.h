// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/roof_part.h"

#include <span>
#include <vector>

namespace ridgeline::simulate {

/// The ground that a building stands on.
struct GroundPlane {
  PlanFunction height;
  int plane_id = kNone;  ///< index into SyntheticScene::planes
};

/// Where walls of the parts meet the ground or the roof of another part: lines of kind foot, each
/// on the lower surface. Overhanging roofs do not cut them off. Chimneys give none; pieces below
/// 0.5 m are left out. `faces`: roof_faces() of the parts.
std::vector<SceneLine> wall_feet(std::span<const RoofPart> parts,
                                 std::span<const PartFace> faces,
                                 const GroundPlane& ground);

}  // namespace ridgeline::simulate
