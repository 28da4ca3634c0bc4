// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/orientation.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace ridgeline {
namespace {

Eigen::Vector2d reduced(const InteriorOrientation& interior, const Eigen::Vector2d& x_px) {
  return (x_px - interior.principal_point_px).cwiseQuotient(interior.focal_length_px);
}

Eigen::Vector2d pixel(const InteriorOrientation& interior, const Eigen::Vector2d& x) {
  return x.cwiseProduct(interior.focal_length_px) + interior.principal_point_px;
}

Eigen::Vector2d distort(const BrownDistortion& d, const Eigen::Vector2d& v) {
  const double x = v.x();
  const double y = v.y();
  const double r2 = v.squaredNorm();
  const double radial = 1.0 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
  return {x * radial + 2.0 * d.p1 * x * y + d.p2 * (r2 + 2.0 * x * x),
          y * radial + d.p1 * (r2 + 2.0 * y * y) + 2.0 * d.p2 * x * y};
}

/// d distort / d v.
Eigen::Matrix2d distortion_jacobian(const BrownDistortion& d, const Eigen::Vector2d& v) {
  const double x = v.x();
  const double y = v.y();
  const double r2 = v.squaredNorm();
  const double radial = 1.0 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
  const double slope = 2.0 * (d.k1 + r2 * (2.0 * d.k2 + 3.0 * r2 * d.k3));  // 2 d radial / d r2
  const double mixed = slope * x * y + 2.0 * d.p1 * x + 2.0 * d.p2 * y;
  Eigen::Matrix2d J;
  J << radial + slope * x * x + 2.0 * d.p1 * y + 6.0 * d.p2 * x, mixed, mixed,
      radial + slope * y * y + 6.0 * d.p1 * y + 2.0 * d.p2 * x;
  return J;
}

}  // namespace

InteriorOrientation interior_orientation(double focal_length_mm,
                                         double pixel_size_um,
                                         const Eigen::Vector2i& size_px,
                                         const Eigen::Vector2d& principal_point_mm) {
  check(focal_length_mm > 0.0, "focal_length_mm = ", focal_length_mm, ", must be positive");
  check(pixel_size_um > 0.0, "pixel_size_um = ", pixel_size_um, ", must be positive");
  check((size_px.array() > 0).all(), "size_px = ", size_px.transpose(), ", must be positive");
  constexpr double kMicrometresPerMillimetre = 1000.0;
  const double pixels_per_mm = kMicrometresPerMillimetre / pixel_size_um;
  const Eigen::Vector2d centre_px = 0.5 * (size_px.cast<double>() - Eigen::Vector2d::Ones());
  const Eigen::Vector2d offset_down_mm(principal_point_mm.x(), -principal_point_mm.y());
  return {Eigen::Vector2d::Constant(focal_length_mm * pixels_per_mm),
          centre_px + pixels_per_mm * offset_down_mm,
          {},
          size_px};
}

Eigen::Matrix3d world_from_camera_axes(double omega_rad, double phi_rad, double kappa_rad) {
  return (Eigen::AngleAxisd(omega_rad, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(phi_rad, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(kappa_rad, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

ProjectionMatrix projection_matrix(const InteriorOrientation& interior,
                                   const ExteriorOrientation& exterior) {
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();
  K.diagonal().head<2>() = interior.focal_length_px;
  K.col(2).head<2>() = interior.principal_point_px;
  // The flip converts axes x right, y up, z backwards to x right, y down, z forwards.
  const Eigen::Vector3d flip(1.0, -1.0, -1.0);
  const Eigen::Matrix3d KR = K * flip.asDiagonal() * exterior.world_from_camera_axes.transpose();
  ProjectionMatrix P;
  P << KR, -KR * exterior.position_m;
  return P;
}

ProjectionMatrix window_from_world(const ProjectionMatrix& image_from_world,
                                   const Eigen::Vector2d& window_px) {
  ProjectionMatrix P = image_from_world;
  P.topRows<2>() -= window_px * P.row(2);
  return P;
}

Eigen::Vector2d distorted_px(const InteriorOrientation& interior, const Eigen::Vector2d& ideal_px) {
  return pixel(interior, distort(interior.distortion, reduced(interior, ideal_px)));
}

std::optional<Eigen::Vector2d> undistorted_px(const InteriorOrientation& interior,
                                              const Eigen::Vector2d& observed_px) {
  constexpr int kMaxIterations = 50;  // converges in 4 within a calibrated field
  constexpr double kTolerancePx = 1e-10;
  const Eigen::Vector2d target = reduced(interior, observed_px);
  Eigen::Vector2d x = target;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Eigen::Vector2d residual = distort(interior.distortion, x) - target;
    const Eigen::Matrix2d J = distortion_jacobian(interior.distortion, x);
    // Beyond the fold of the polynomial the distorted radius decreases again, so a solution there
    // is not the ideal pixel.
    if (!(J.determinant() > 0.0)) return std::nullopt;
    if (residual.cwiseProduct(interior.focal_length_px).norm() <= kTolerancePx) {
      return pixel(interior, x);
    }
    x -= J.inverse() * residual;
  }
  return std::nullopt;
}

}  // namespace ridgeline
