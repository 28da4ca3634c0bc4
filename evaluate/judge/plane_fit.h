// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/plane.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// A plane fitted by total least squares, with what is needed to compute its standard deviation at
/// any point.
struct PlaneFit {
  Plane3 plane{Eigen::Vector3d::UnitZ(), 0.0};  ///< normal upwards
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 2> axes;  ///< unit, in the plane: largest, then second spread
  Eigen::Vector2d spread_m2;         ///< sums of squares along `axes`
  int n = 0;
  double rms_m = 0.0;     ///< root of the mean squared orthogonal residual
  double sigma0_m = 0.0;  ///< like rms_m, but with n - 3 degrees of freedom instead of n

  /// Standard deviation of the plane, along its normal, at the foot point of `x`: with the plane
  /// coordinates (u, v) of x relative to the centroid, sigma0 sqrt(1/n + u^2/Suu + v^2/Svv). It
  /// grows linearly outside the points. It is optimistic, because neighbouring returns are
  /// correlated.
  [[nodiscard]] double sigma_at(const Eigen::Vector3d& x) const;
};

/// Orthogonal regression: the eigenvector of the smallest eigenvalue of the scatter matrix about
/// the centroid, in double. Empty for fewer than 4 points or collinear points.
std::optional<PlaneFit> fit_plane(std::span<const Eigen::Vector3d> points);

}  // namespace ridgeline::evaluate
