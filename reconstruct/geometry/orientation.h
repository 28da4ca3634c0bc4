// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"

#include <Eigen/Core>

#include <optional>

namespace ridgeline {

/// Brown's distortion (Brown 1971) in image coordinates relative to the principal point and divided
/// by the focal length, x right, y down, r^2 = x^2 + y^2. From ideal to distorted:
///   x_d = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)
///   y_d = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y
/// All coefficients are dimensionless, as in OpenCV and COLMAP.
struct BrownDistortion {
  double k1 = 0.0, k2 = 0.0, k3 = 0.0, p1 = 0.0, p2 = 0.0;
  [[nodiscard]] bool is_zero() const {
    return k1 == 0.0 && k2 == 0.0 && k3 == 0.0 && p1 == 0.0 && p2 == 0.0;
  }
};

/// Pixel (0,0) is the centre of the top-left pixel, columns run right, rows down.
struct InteriorOrientation {
  Eigen::Vector2d focal_length_px = Eigen::Vector2d::Ones();  ///< along columns and rows
  Eigen::Vector2d principal_point_px = Eigen::Vector2d::Zero();
  BrownDistortion distortion;
  std::optional<Eigen::Vector2i> size_px;  ///< columns, rows of the frame, if known
};

/// The interior orientation of a frame camera from its calibration. The principal point is given as
/// an offset from the image centre, x right, y UP, as in photogrammetric image coordinates; the
/// centre of an image of W columns is at column (W - 1) / 2.
/// Throws std::invalid_argument unless focal length, pixel size and image size are positive.
InteriorOrientation interior_orientation(double focal_length_mm,
                                         double pixel_size_um,
                                         const Eigen::Vector2i& size_px,
                                         const Eigen::Vector2d& principal_point_mm);

/// Rx(omega) Ry(phi) Rz(kappa): rotates camera axes (x right, y up in the image, looking along -z)
/// to world axes.
Eigen::Matrix3d world_from_camera_axes(double omega_rad, double phi_rad, double kappa_rad);

struct ExteriorOrientation {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< projection centre, world
  Eigen::Matrix3d world_from_camera_axes = Eigen::Matrix3d::Identity();
};

/// K diag(1,-1,-1) R^T [I | -C] with R = world_from_camera_axes, for ideal (undistorted) pixels;
/// the third coordinate of P x is the depth of x in front of the camera.
ProjectionMatrix projection_matrix(const InteriorOrientation& interior,
                                   const ExteriorOrientation& exterior);

/// P for a window of the full frame whose top-left pixel is `window_px` = (column, row) of the
/// frame.
ProjectionMatrix window_from_world(const ProjectionMatrix& image_from_world,
                                   const Eigen::Vector2d& window_px);

/// The distorted pixel of an ideal pixel.
Eigen::Vector2d distorted_px(const InteriorOrientation& interior, const Eigen::Vector2d& ideal_px);

/// The inverse of distorted_px(), by Newton's method, to 1e-10 px. std::nullopt where the
/// distortion has no inverse, which happens outside the field for which it was calibrated.
std::optional<Eigen::Vector2d> undistorted_px(const InteriorOrientation& interior,
                                              const Eigen::Vector2d& observed_px);

}  // namespace ridgeline
