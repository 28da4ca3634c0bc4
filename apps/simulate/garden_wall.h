// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/random.h"
#include "apps/simulate/terrain.h"

#include <Eigen/Core>

namespace ridgeline::simulate {

/// Adds a wall, 0.3 m wide, 0.8 to 1.8 m high and 5 to 15 m long, on the border of a lot at its low
/// u; none if it leaves the plan. Its top is parallel to the ground. Its lines: both long sides of
/// the top and, `with_feet`, both feet.
void add_garden_wall(const Terrain& terrain,
                     const TerrainRow& row,
                     const Eigen::Vector2d& low_uv,
                     bool with_feet,
                     Random& random,
                     SyntheticScene& scene);

}  // namespace ridgeline::simulate
