// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <numbers>

namespace ridgeline::evaluate {

/// Tangent of the largest angle between a laser ray and the vertical, 31 degrees: airborne scanners
/// look up to 30 degrees to each side.
inline constexpr double kMaxRayTangent = 0.6;

/// Whether an oblique ray that passes the edge of a roof may have hit this position below it: a
/// wall, or the ground under an overhang.
/// @param x        in plan
/// @param below_m  how far it lies below the roof
/// @param is_over  whether a position in plan lies under the roof
template <typename IsOver>
bool is_under_overhang(const Eigen::Vector2d& x, double below_m, const IsOver& is_over) {
  constexpr int kDirections = 8;
  if (below_m <= 0.0) return false;
  for (int i = 0; i < kDirections; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kDirections;
    const Eigen::Vector2d towards(std::cos(angle_rad), std::sin(angle_rad));
    if (!is_over(Eigen::Vector2d(x + kMaxRayTangent * below_m * towards))) return true;
  }
  return false;
}

}  // namespace ridgeline::evaluate
