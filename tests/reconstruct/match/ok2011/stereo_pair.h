// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/epipolar_transfer.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace ridgeline::test {

/// Two vertical frames 800 m above z = 0, base 208 m along x unless told (B/H 0.26), f = 10,000 px,
/// so that a metre is 12.5 px on the ground and moves 3.25 px per metre of height. The left image
/// has the origin at pixel (0, 0), the right one too for z = 0. `kappa_rad` turns the right image.
struct StereoPair {
  static constexpr double kFocal_px = 10000.0;
  static constexpr double kHeight_m = 800.0;
  static constexpr double kBase_m = 208.0;
  static constexpr double kWideBase_m = 480.0;  ///< B/H 0.6

  ProjectionMatrix left = camera(0.0, 0.0);
  ProjectionMatrix right;
  std::array<double, 2> heights_m{-5.0, 45.0};

  explicit StereoPair(double kappa_rad = 0.0, double base_m = kBase_m)
      : right(camera(base_m, kappa_rad)) {}

  static ProjectionMatrix camera(double x_m, double kappa_rad) {
    Eigen::Matrix3d rotation = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();  // looks down
    ProjectionMatrix cam_from_local;
    cam_from_local.leftCols<3>() = rotation;
    cam_from_local.col(3) = -rotation * Eigen::Vector3d(x_m, 0.0, kHeight_m);
    Eigen::Matrix3d image_from_cam = Eigen::Vector3d(kFocal_px, kFocal_px, 1.0).asDiagonal();
    image_from_cam(0, 2) = kFocal_px * x_m / kHeight_m;  // the origin falls on (0, 0)
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(kappa_rad).toRotationMatrix();
    return turn * image_from_cam * cam_from_local;
  }

  [[nodiscard]] reconstruct::StereoSearch search() const { return {left, right, heights_m}; }
};

/// A segment as an extraction would give it, with the precision of a good edge.
inline EdgeSegment edge(const Segment2& s) {
  EdgeSegment segment;
  segment.line.segment = s;
  segment.line.centroid_px = midpoint(s);
  segment.line.sigma_q_px = 0.05;
  segment.line.sigma_phi_rad = 0.2 / length(s);
  segment.line.sigma_e_px = 1.0;
  segment.in_image = s;
  return segment;
}

}  // namespace ridgeline::test
