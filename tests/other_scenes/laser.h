// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/ray_tracer.h"
#include "tests/other_scenes/scene_model.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ridgeline::other {

/// Returns of an airborne scanner from two strips, over the patch and 8 m beyond. Noise of 3.4 cm
/// per axis; half of the pulses pass a leaf.
std::vector<Eigen::Vector3d> laser_points(const Scene& scene,
                                          const RayTracer& tracer,
                                          std::uint64_t seed,
                                          double density_per_m2);

}  // namespace ridgeline::other
