// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/random_stream.h"
#include "tests/other_scenes/scene_model.h"

#include <Eigen/Core>

namespace ridgeline::other {

/// A patch of ground with its four borders as edges.
void add_ground(Scene& scene, const GroundPatch& patch);

/// A car, heading `along` (unit).
void add_car(Scene& scene,
             const Eigen::Vector2d& place,
             const Eigen::Vector2d& along,
             RandomStream& random);

/// Crown and stem; radius_m in plan.
void add_tree(Scene& scene, const Eigen::Vector2d& place, double radius_m, RandomStream& random);

/// A row of bushes, irregular: no straight edges.
void add_hedge(Scene& scene,
               const Eigen::Vector2d& from,
               const Eigen::Vector2d& to,
               RandomStream& random);

/// A wooden fence or a garden wall, straight edges along both sides of its top.
void add_fence(Scene& scene,
               const Eigen::Vector2d& from,
               const Eigen::Vector2d& to,
               RandomStream& random);

}  // namespace ridgeline::other
