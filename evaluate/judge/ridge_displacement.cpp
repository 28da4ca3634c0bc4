// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/ridge_displacement.h"

#include "reconstruct/geometry/degrees.h"

#include <Eigen/LU>

#include <cmath>

namespace ridgeline::evaluate {

Eigen::Vector3d across_in_plan(const Segment3& segment) {
  const Eigen::Vector2d along = (segment.end - segment.start).head<2>().normalized();
  const Eigen::Vector2d left(-along.y(), along.x());
  const bool is_to_larger = left.x() > 0.0 || (left.x() == 0.0 && left.y() > 0.0);
  const Eigen::Vector2d h = is_to_larger ? left : Eigen::Vector2d(-left);
  return {h.x(), h.y(), 0.0};
}

std::optional<RidgeDisplacement> ridge_displacement(const Segment3& segment,
                                                    const std::array<Plane3, 2>& planes,
                                                    const std::array<double, 2>& sigmas_m) {
  const Eigen::Vector2d along = (segment.end - segment.start).head<2>();
  const double angle_deg = deg_from_rad(
      acute_angle_rad(Eigen::Vector3d(planes[0].normal()), Eigen::Vector3d(planes[1].normal())));
  if (!(along.norm() > 0.0) || angle_deg < kMinRidgeAngle_deg) return std::nullopt;
  const Eigen::Vector3d h = across_in_plan(segment);
  const Eigen::Vector3d x = midpoint(segment);
  Eigen::Matrix2d n;
  Eigen::Vector2d d;
  Eigen::Vector2d variances_m2;
  for (int i = 0; i < 2; ++i) {
    const Plane3& plane = planes[static_cast<std::size_t>(i)];
    n.row(i) << plane.normal().dot(h), plane.normal().z();
    d[i] = plane.signedDistance(x);
    variances_m2[i] = std::pow(sigmas_m[static_cast<std::size_t>(i)], 2);
  }
  if (!(std::abs(n.determinant()) > 0.0)) return std::nullopt;
  const Eigen::Matrix2d inverse = n.inverse();
  const Eigen::Vector2d parts = inverse * d;
  return RidgeDisplacement{
      .horizontal_m = parts[0],
      .vertical_m = parts[1],
      .covariance_m2 = inverse * variances_m2.asDiagonal() * inverse.transpose()};
}

}  // namespace ridgeline::evaluate
