// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/furniture.h"
#include "apps/simulate/random.h"
#include "apps/simulate/terrain.h"

#include <Eigen/Core>

namespace ridgeline::simulate {

/// Adds a wall, 0.3 m wide, 0.8 to 1.8 m high and 5 to 15 m long, on the border of a lot at its low u; none if it leaves the
/// plan. Its top is parallel to the ground. Its lines: both long sides of the top and, `with_feet`, both feet.
void add_garden_wall(const Terrain& terrain,
                     const Row& row,
                     const Eigen::Vector2d& low_uv,
                     bool with_feet,
                     Random& random,
                     Scene& scene);

/// A car of random size, its foot at the origin.
Car random_car(Random& random);

/// Adds a car and, `with_lines`, its upper edges as true lines.
void add_parked_car(const Car& car, bool with_lines, Scene& scene);

/// Adds the upper edges of all chimneys as true lines.
void add_chimney_lines(Scene& scene);

}  // namespace ridgeline::simulate
