// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <array>

namespace ridgeline::reconstruct {

/// The possible positions in one image of a point of the other: the image y ~ a + z b of its ray, a
/// line in homogeneous pixels with the object height z (m, local frame) as parameter.
struct Stretch {
  Eigen::Vector3d a, b;

  /// Pixel for a given height; not finite where the ray meets the plane of the projection centre.
  [[nodiscard]] Eigen::Vector2d at(double z_m) const { return (a + z_m * b).hnormalized(); }
  /// dy/dz, pixels per metre of height.
  [[nodiscard]] Eigen::Vector2d derivative(double z_m) const;
  /// Height at which the stretch crosses the line n.y = c, |n| = 1. It is not finite if the line is
  /// parallel to the stretch.
  [[nodiscard]] double height_on(const Eigen::Vector2d& n, double c) const;
};

/// Transfers points between two oriented images by way of the object height. The cameras may have
/// any orientation, but the stretch of a horizontal ray is not finite.
class EpipolarTransfer {
 public:
  EpipolarTransfer(const ProjectionMatrix& from, const ProjectionMatrix& to);

  [[nodiscard]] Stretch stretch(const Eigen::Vector2d& x_from) const;
  /// The point of the ray at a given height.
  [[nodiscard]] Eigen::Vector3d object_point(const Eigen::Vector2d& x_from, double z_m) const;
  /// F with x_to' F x_from = 0.
  [[nodiscard]] const Eigen::Matrix3d& fundamental() const { return fundamental_; }
  /// Projection centre of the first image.
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }

 private:
  Eigen::Matrix3d ray_from_pixel_;
  Eigen::Vector3d centre_;
  ProjectionMatrix to_;
  Eigen::Matrix3d fundamental_;
};

/// The affine map that approximates the transfer near a point and a height: y(x0 + dx, z0 + dz) ~
/// y(x0, z0) + jacobian dx + per_height dz.
struct LocalTransfer {
  Eigen::Matrix2d jacobian;
  Eigen::Vector2d per_height;  ///< px/m
  double gsd_m = 0.0;          ///< size of a pixel of the first image on the horizontal plane at z0

  /// Ratio of the parallax that a height causes to this height, both in pixels.
  [[nodiscard]] double base_to_height() const { return per_height.norm() * gsd_m; }
  /// Acute angle between a segment of the first image, transferred, and one of the second image.
  [[nodiscard]] double turn_rad(const Segment2& from, const Segment2& to) const {
    return acute_angle_rad(Eigen::Vector2d(jacobian * (from.end - from.start)),
                           Eigen::Vector2d(to.end - to.start));
  }
};
LocalTransfer local_transfer(const EpipolarTransfer& transfer,
                             const Eigen::Vector2d& x_from,
                             double z_m);

/// The transfer of a stereo pair in both directions, and the heights to search.
struct StereoSearch {
  EpipolarTransfer right_from_left, left_from_right;
  std::array<double, 2> height_range_m;

  /// Throws std::invalid_argument if the matrices or heights are not finite, the range does not run
  /// from lowest to highest, or the cameras have no epipolar geometry.
  StereoSearch(const ProjectionMatrix& left,
               const ProjectionMatrix& right,
               const std::array<double, 2>& height_range_in_local_m);
};

/// Transfer from the left image to the right one, at the middle of the height range.
LocalTransfer local_transfer(const StereoSearch& search, const Eigen::Vector2d& x_left);

}  // namespace ridgeline::reconstruct
