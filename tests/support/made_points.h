// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/made_buildings.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::test {

/// Which way the points of a scan err.
enum class NoiseDirection : std::uint8_t { kNormal, kVertical };

struct ScanSpec {
  double points_per_m2 = 5.0;  ///< in plan
  double sigma_m = 0.034;
  NoiseDirection noise = NoiseDirection::kNormal;  ///< of the surface
  double margin_m = 5.0;                           ///< of ground around the buildings' common box
  std::uint64_t seed = 1;
};

/// Points at random places in plan, each on the uppermost roof face there or, beside all of them,
/// on the ground: level, at the height of the nearest building's foot. What a laser scanner from
/// straight above would see; walls get no points.
std::vector<Eigen::Vector3d> scan(std::span<const MadeBuilding> buildings, const ScanSpec& spec);

}  // namespace ridgeline::test
