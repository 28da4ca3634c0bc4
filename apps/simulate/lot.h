// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/random.h"
#include "apps/simulate/scene.h"
#include "apps/simulate/village.h"
#include "apps/simulate/wall_feet.h"

#include <Eigen/Core>

namespace ridgeline::simulate {

inline constexpr double kLotSizeM = 20.0;
/// A house stays within this distance of the middle of its lot, whatever its azimuth.
inline constexpr double kHouseRadiusM = 9.7;

/// Where a house may stand.
struct Site {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();  ///< plan, local
  double azimuth_rad = 0.0;                            ///< azimuth of the main ridge
  double floor_z_m = 0.0;                              ///< lowest ground of the site
  GroundPlane ground{};
};

/// Adds a random house of the given type: its parts, lines, planes and SceneBuilding record(s).
/// `clutter` is the random stream for annexes and small dormers.
void add_house(const VillageOptions& options,
               RoofType type,
               const Site& site,
               Random& random,
               Random& clutter,
               SyntheticScene& scene);

}  // namespace ridgeline::simulate
