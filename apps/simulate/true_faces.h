// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/roof_part.h"

#include <span>
#include <vector>

namespace ridgeline::simulate {

/// The faces of the buildings that the parts belong to, without chimneys, in the order of the
/// buildings: roofs with their overhang, without thickness; walls at their true position, from the
/// foundation to the roof; one or more ground faces below the foundations. Anything inside another
/// part of the same building is removed, so the roof faces of a building cover its plan once. Party
/// walls between two buildings are complete on both sides. The faces do not form a closed surface
/// where roofs overhang.
std::vector<Face> true_faces(std::span<const RoofPart> parts, std::span<const PartFace> roof_faces);

}  // namespace ridgeline::simulate
