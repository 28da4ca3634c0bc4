// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/roof_part.h"

#include <span>
#include <vector>

namespace ridgeline::simulate {

/// The faces of the buildings that the parts belong to, without chimneys, in the order of the
/// buildings: roofs with their overhang, as thin as paper; walls where they stand, from the
/// foundation to the roof; one or more faces of the ground below the foundations. What lies inside
/// another part of the same building is cut away, so the roof faces of a building cover its plan
/// once. Party walls between two buildings are whole on both sides. Faces do not close where roofs
/// overhang.
std::vector<Face> true_faces(std::span<const RoofPart> parts, std::span<const PartFace> roof_faces);

}  // namespace ridgeline::simulate
