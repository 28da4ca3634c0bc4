// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/random_stream.h"
#include "tests/other_scenes/scene_model.h"

#include <Eigen/Core>

namespace ridgeline::other {

/// Puts a house of random type (gable, hip, half-hip, L-shaped if there is room for a second wing,
/// flat with parapet, shed) into the scene, its longer side `along` (unit), with chimney, dormers,
/// roof windows, solar modules. `clutter`, unless it is null, draws an annex, at a longer side if
/// there is room, else at an end, and small dormers.
void add_house(Scene& scene,
               const Eigen::Vector2d& place,
               const Eigen::Vector2d& along,
               bool has_room,
               RandomStream& random,
               RandomStream* clutter);

/// A garage with a flat or a gable roof.
void add_garage(Scene& scene,
                const Eigen::Vector2d& place,
                const Eigen::Vector2d& along,
                RandomStream& random);

}  // namespace ridgeline::other
