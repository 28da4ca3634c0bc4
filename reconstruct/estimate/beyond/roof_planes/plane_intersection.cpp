// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/roof_planes/plane_intersection.h"

namespace ridgeline::reconstruct {

PointOfPlanes point_of_planes(const Rectification& r,
                              const Eigen::Vector3d& first,
                              const Eigen::Vector3d& second,
                              const Eigen::Vector2d& x_px) {
  const Eigen::Vector3d by = x_px.homogeneous();
  const Eigen::Vector2d bend = (first - second).head<2>();
  const Eigen::Vector2d across = -bend / bend.squaredNorm();
  Eigen::Matrix<double, 2, 6> x_by_planes;
  x_by_planes << across * by.transpose(), -across * by.transpose();
  Eigen::Matrix<double, 1, 6> d_by_planes = first.head<2>().transpose() * x_by_planes;
  d_by_planes.head<3>() += by.transpose();
  // X = C + R' (x - x_0, f)' B / d
  const double d_px = first.dot(by);
  const double m_per_px = r.base_m / d_px;
  Eigen::Vector3d ray;
  ray << x_px - r.principal_point_px, r.focal_px;
  Eigen::Matrix<double, 3, 6> in_camera = -m_per_px / d_px * ray * d_by_planes;
  in_camera.topRows<2>() += m_per_px * x_by_planes;
  return {r.point_in_local(x_px, d_px), r.rectified_from_local.transpose() * in_camera};
}

}  // namespace ridgeline::reconstruct
