// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <cstdint>

namespace ridgeline::simulate {

/// Adds to the mesh details that are visible in images of a village but absent from its laser
/// points and true lines: windows on the walls, skylights and solar panels on the roofs, terraces
/// and paths on the lawns. All lie within 0.12 m of the surface they are on. Their random numbers
/// follow from the seed and are independent of all others.
void add_fittings(SyntheticScene& scene, std::uint64_t seed);

}  // namespace ridgeline::simulate
