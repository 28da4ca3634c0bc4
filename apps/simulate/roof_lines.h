// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/roof_part.h"

#include <span>
#include <vector>

namespace ridgeline::simulate {

/// All edges of the upper envelope of the parts: true lines and joints (kind kJoint). Pieces
/// covered from above by another part are removed. Chimneys cover other parts, but have no lines
/// themselves.
std::vector<SceneLine> roof_lines(std::span<const RoofPart> parts, std::span<const PartFace> faces);

}  // namespace ridgeline::simulate
