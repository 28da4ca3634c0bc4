// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/scene_model.h"
#include "tests/other_scenes/solids.h"

#include <Eigen/Geometry>

#include <array>

namespace ridgeline::other {

/// A part of a house with a ridge along x, in a frame of its own with the ridge above y = 0.
struct Wing {
  Eigen::Isometry3d house_from_wing = Eigen::Isometry3d::Identity();
  double length_m = 12.0, width_m = 9.0;  ///< of the roof in plan, overhang included
  double overhang_m = 0.4;
  double eave_m = 3.0, ridge_m = 7.0;
  /// At the ends x < 0 and x > 0: the share of the height of the roof that is hipped, 0: gable,
  /// 1: hip, between: half-hip.
  std::array<double, 2> hipped{0.0, 0.0};
  Look roof, walls;

  [[nodiscard]] double slope() const { return 2.0 * (ridge_m - eave_m) / width_m; }
  /// Height of the (infinite) main roof planes at a distance from the ridge in plan.
  [[nodiscard]] double roof_m(double y) const { return ridge_m - slope() * std::abs(y); }
};

/// Roof and walls as two solids, with ridge, hips, eaves and verges.
void add_wing(Solids& solids, const Wing& wing);

/// One plane that rises from y < 0 to y > 0, on walls.
void add_shed(Solids& solids, const Wing& wing);

/// A flat roof at ridge_m behind a parapet that is `parapet_m` higher.
void add_flat(Solids& solids, const Wing& wing, double parapet_m);

}  // namespace ridgeline::other
