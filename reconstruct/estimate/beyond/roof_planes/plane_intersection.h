// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/rectification.h"

#include <Eigen/Core>

namespace ridgeline::reconstruct {

struct PointOfPlanes {
  Eigen::Vector3d x_in_local;
  /// Jacobian with respect to (a, b, c) of the first and of the second plane.
  Eigen::Matrix<double, 3, 6> by_planes;
};

/// The point of two planes at a given position on their intersection in the rectified left view. If
/// the planes change, the point moves across the intersection, not along it.
/// @param first, second  planes d = a x + b y + c, of different slope (a, b)
/// @param x_px           position on the intersection
PointOfPlanes point_of_planes(const Rectification& r,
                              const Eigen::Vector3d& first,
                              const Eigen::Vector3d& second,
                              const Eigen::Vector2d& x_px);

}  // namespace ridgeline::reconstruct
