// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/random.h"
#include "apps/simulate/scene.h"

#include <Eigen/Core>

namespace ridgeline::simulate {

/// Adds a crown of many small random leaves, so that a laser pulse meets some of them and may pass,
/// over a thin trunk. `foot`: where the trunk meets the ground.
void add_tree(const Eigen::Vector3d& foot,
              double crown_radius_m,
              double height_m,
              Random& random,
              Mesh& mesh);

/// Adds the body and the cabin of a car.
void add_car(const Eigen::Vector3d& foot, double azimuth_rad, Mesh& mesh);

}  // namespace ridgeline::simulate
