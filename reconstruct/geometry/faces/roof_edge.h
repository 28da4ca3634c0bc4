// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cmath>
#include <numbers>

namespace ridgeline {

/// Edges and faces of roofs with a smaller slope are level.
inline constexpr double kLevelRoof_rad = 5.0 * kRadPerDeg;

inline bool is_level(const Segment3& edge) {
  const Eigen::Vector3d d = edge.end - edge.start;
  return std::atan2(std::abs(d.z()), d.head<2>().norm()) < kLevelRoof_rad;
}

/// The kind of the border of a roof face: `step` for a level face, otherwise `eave` across its
/// slope (more than 45 degrees from the slope in plan) or `verge` along it.
inline const char* kind_of_border(const Plane3& roof, const Segment3& edge) {
  if (slope_rad(roof) < kLevelRoof_rad) return "step";
  const Eigen::Vector2d down = roof.normal().head<2>().normalized();
  const Eigen::Vector2d along = (edge.end - edge.start).head<2>().normalized();
  return std::abs(down.dot(along)) < std::numbers::sqrt2 / 2.0 ? "eave" : "verge";
}

}  // namespace ridgeline
