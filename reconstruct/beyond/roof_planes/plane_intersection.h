// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/surface/rectification.h"

#include <Eigen/Core>

namespace ridgeline::reconstruct {

struct PointOfPlanes {
  Eigen::Vector3d x_in_local;
  Eigen::Matrix<double, 3, 6>
      by_planes;  ///< Jacobian by (a, b, c) of the first and of the second plane
};

/// The point of two planes at a place on their intersection in the rectified left view. As the planes change it moves
/// across the intersection, not along it.
/// @param first, second  d = a x + b y + c, of different slope (a, b)
/// @param x_px           on the intersection
PointOfPlanes point_of_planes(const Rectification& r,
                              const Eigen::Vector3d& first,
                              const Eigen::Vector3d& second,
                              const Eigen::Vector2d& x_px);

}  // namespace ridgeline::reconstruct
