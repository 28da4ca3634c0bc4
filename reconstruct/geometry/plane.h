// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace ridgeline {

/// n'x + d = 0 with |n| = 1.
using Plane3 = Eigen::Hyperplane<double, 3>;

/// The same plane with its normal turned upwards. The normal of a vertical plane is turned towards
/// increasing x, or towards increasing y if its x component is 0. Signed distances are comparable
/// only between planes in this form.
inline Plane3 upward(const Plane3& plane) {
  const Eigen::Vector3d n = plane.normal();
  const bool down = n.z() != 0.0 ? n.z() < 0.0 : (n.x() != 0.0 ? n.x() < 0.0 : n.y() < 0.0);
  return down ? Plane3(Eigen::Vector3d(-n), -plane.offset()) : plane;
}

/// Height of the plane at a plan position; infinite or NaN for a vertical plane.
inline double height_at(const Plane3& plane, const Eigen::Vector2d& x) {
  return -(plane.normal().head<2>().dot(x) + plane.offset()) / plane.normal().z();
}

/// Angle to the horizontal in [0, pi/2].
inline double slope_rad(const Plane3& plane) {
  return std::atan2(plane.normal().head<2>().norm(), std::abs(plane.normal().z()));
}

}  // namespace ridgeline
