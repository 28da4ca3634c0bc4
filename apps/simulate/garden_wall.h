// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/random.h"
#include "apps/simulate/terrain.h"

#include <Eigen/Core>

namespace ridgeline::simulate {

/// Adds a wall, 0.3 m wide, 0.8 to 1.8 m high and 5 to 15 m long, on the low-u border of a lot,
/// unless it would extend beyond the plan. Its top is parallel to the ground. Its lines are both
/// long sides of the top and, if `with_feet`, of the foot.
void add_garden_wall(const Terrain& terrain,
                     const TerrainRow& row,
                     const Eigen::Vector2d& low_uv,
                     bool with_feet,
                     Random& random,
                     SyntheticScene& scene);

}  // namespace ridgeline::simulate
