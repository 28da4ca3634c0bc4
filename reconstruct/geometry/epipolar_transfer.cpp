// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/epipolar_transfer.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace ridgeline::reconstruct {

Eigen::Vector2d Stretch::derivative(double z_m) const {
  // This is the quotient rule for (a + z b)_xy / (a + z b)_w.
  const Eigen::Vector3d y = a + z_m * b;
  return (b.head<2>() - y.head<2>() * (b.z() / y.z())) / y.z();
}

double Stretch::height_on(const Eigen::Vector2d& n, double c) const {
  const Eigen::Vector3d line(n.x(), n.y(), -c);
  return -line.dot(a) / line.dot(b);
}

EpipolarTransfer::EpipolarTransfer(const ProjectionMatrix& from, const ProjectionMatrix& to)
    : ray_from_pixel_(from.leftCols<3>().inverse()),
      centre_(-ray_from_pixel_ * from.col(3)),
      to_(to),
      fundamental_(fundamental_matrix(from, to)) {}

Stretch EpipolarTransfer::stretch(const Eigen::Vector2d& x_from) const {
  const Eigen::Vector3d ray = ray_from_pixel_ * x_from.homogeneous();
  const Eigen::Vector3d per_height = ray / ray.z();
  const Eigen::Vector3d foot = centre_ - centre_.z() * per_height;  // where the ray has z = 0
  return {to_ * foot.homogeneous(), to_.leftCols<3>() * per_height};
}

Eigen::Vector3d EpipolarTransfer::object_point(const Eigen::Vector2d& x_from, double z_m) const {
  const Eigen::Vector3d ray = ray_from_pixel_ * x_from.homogeneous();
  return centre_ + (z_m - centre_.z()) / ray.z() * ray;
}

LocalTransfer local_transfer(const EpipolarTransfer& transfer,
                             const Eigen::Vector2d& x_from,
                             double z_m) {
  constexpr double kStep_px = 1.0;  // the transfer is a homography of tiny curvature
  const Stretch stretch = transfer.stretch(x_from);
  LocalTransfer local;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = kStep_px * Eigen::Vector2d::Unit(axis);
    local.jacobian.col(axis) =
        (transfer.stretch(x_from + step).at(z_m) - transfer.stretch(x_from - step).at(z_m)) /
        (2.0 * kStep_px);
  }
  local.per_height = stretch.derivative(z_m);
  const Eigen::Vector3d x = transfer.object_point(x_from, z_m);
  const Eigen::Vector3d along = transfer.object_point(x_from + Eigen::Vector2d::UnitX(), z_m) - x;
  const Eigen::Vector3d across = transfer.object_point(x_from + Eigen::Vector2d::UnitY(), z_m) - x;
  local.gsd_m = std::sqrt(along.head<2>().norm() * across.head<2>().norm());
  return local;
}

StereoSearch::StereoSearch(const ProjectionMatrix& left,
                           const ProjectionMatrix& right,
                           const std::array<double, 2>& height_range_in_local_m)
    : right_from_left(left, right),
      left_from_right(right, left),
      height_range_m(height_range_in_local_m) {
  check(left.allFinite() && right.allFinite(), "projection matrix: not finite, must be numbers");
  const auto [lowest, highest] = height_range_m;
  check(std::isfinite(lowest) && std::isfinite(highest) && lowest < highest,
        "height_range = ", lowest, " .. ", highest, ", must run from the lowest to the highest");
  constexpr double kSamePlace_m = 1e-6;
  check(right_from_left.fundamental().allFinite() &&
            (right_from_left.centre() - left_from_right.centre()).norm() > kSamePlace_m,
        "projection matrices: no epipolar geometry, must be central cameras in two places");
}

LocalTransfer local_transfer(const StereoSearch& search, const Eigen::Vector2d& x_left) {
  const auto [lowest_m, highest_m] = search.height_range_m;
  return local_transfer(search.right_from_left, x_left, 0.5 * (lowest_m + highest_m));
}

}  // namespace ridgeline::reconstruct
