// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/random.h"
#include "apps/simulate/scene.h"

#include <Eigen/Core>

#include <vector>

namespace ridgeline::simulate {

/// Adds a thin trunk with a crown of many small random leaves, so that a laser pulse hits some of
/// them and may pass through. `foot`: where the trunk meets the ground.
void add_tree(const Eigen::Vector3d& foot,
              double crown_radius_m,
              double height_m,
              Random& random,
              Mesh& mesh);

/// A level car: a body with a cabin in its middle, both boxes. Heights are above its foot.
struct Car {
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();  ///< on the ground below its middle
  double azimuth_rad = 0.0;
  double half_length_m = 2.15, half_width_m = 0.88, bonnet_m = 0.85;
  double cabin_half_length_m = 1.2, cabin_half_width_m = 0.75, roof_m = 1.45;
};

void add_car(const Car& car, Mesh& mesh);

/// The upper edges of the car's body and cabin.
std::vector<Segment3> edges_of(const Car& car);

}  // namespace ridgeline::simulate
