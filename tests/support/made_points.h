// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/made_buildings.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::test {

/// The direction in which noise displaces the points of a scan.
enum class NoiseDirection : std::uint8_t { kNormal, kVertical };

struct ScanSpec {
  double points_per_m2 = 5.0;  ///< in plan
  double sigma_m = 0.034;
  NoiseDirection noise = NoiseDirection::kNormal;  ///< kNormal: along the surface normal
  double margin_m = 5.0;  ///< width of the ground around the buildings' common bounding box
  std::uint64_t seed = 1;
};

/// Points at random places in plan, as seen by a laser scanner from straight above: each lies on
/// the uppermost roof face there or, outside all roofs, on the ground, which is level at the height
/// of the nearest building's base. Walls get no points.
std::vector<Eigen::Vector3d> scan(std::span<const MadeBuilding> buildings, const ScanSpec& spec);

}  // namespace ridgeline::test
