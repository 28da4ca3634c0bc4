// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/furniture.h"
#include "apps/simulate/random.h"
#include "apps/simulate/terrain.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace ridgeline::simulate {

/// Adds a car and, if `with_lines`, its upper edges as true lines.
void add_parked_car(const Car& car, bool with_lines, SyntheticScene& scene);

/// A lot with the street in front of it.
struct CarSite {
  const Terrain& terrain;
  const TerrainRow& row;
  Eigen::Vector2d low_uv;
  double street_azimuth_rad = 0.0;
  /// Whether a circle in plan lies within the extent and is clear of houses.
  std::function<bool(const Eigen::Vector2d& x, double radius_m)> is_free;
};

/// Parks cars of random size at the kerb and in the garden, clear of the house, of the places
/// `taken` by trees, and of each other; on average `mean_count` of them if there is room.
void park_cars(const CarSite& site,
               double mean_count,
               bool with_lines,
               std::vector<Eigen::Vector2d> taken,
               Random& random,
               SyntheticScene& scene);

}  // namespace ridgeline::simulate
