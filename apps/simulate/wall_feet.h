// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/roof_part.h"

#include <span>
#include <vector>

namespace ridgeline::simulate {

/// The ground on which a building stands.
struct GroundPlane {
  PlanFunction height;
  int plane_id = kNone;  ///< index into SyntheticScene::planes
};

/// The lines, of kind foot, where walls of the parts meet the ground or the roof of another part,
/// each on the lower surface. Overhanging roofs do not interrupt them. Chimneys have none; pieces
/// shorter than 0.5 m are left out. `faces`: roof_faces() of the parts.
std::vector<SceneLine> wall_feet(std::span<const RoofPart> parts,
                                 std::span<const PartFace> faces,
                                 const GroundPlane& ground);

}  // namespace ridgeline::simulate
