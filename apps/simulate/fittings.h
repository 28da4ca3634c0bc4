// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <cstdint>

namespace ridgeline::simulate {

/// Adds to the mesh what an image shows of a village but its laser points and true lines do not
/// know: windows on the walls, skylights and solar panels on the roofs, terraces and paths on the
/// lawns. All of it lies within 0.12 m of the surface that bears it. The draws follow from the seed
/// and are independent of all other draws.
void add_fittings(SyntheticScene& scene, std::uint64_t seed);

}  // namespace ridgeline::simulate
