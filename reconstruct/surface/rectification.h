// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

/// A pair of views turned so that corresponding pixels lie in one row, further left in the right
/// view by the disparity d > 0. Both turned cameras have the same axes, focal length and principal
/// point; rows run along the base. Rectified pixels are about as large as those of the left image
/// in its middle.
struct Rectification {
  std::array<Eigen::Matrix3d, 2> rectified_from_ideal;  ///< homographies of the views
  Eigen::Matrix3d rectified_from_local;                 ///< rotation of the axes
  Eigen::Vector3d left_centre_m;
  Eigen::Vector2d principal_point_px;
  double focal_px = 0.0, base_m = 0.0;
  cv::Size size;  ///< box of the left image, from (0, 0)

  [[nodiscard]] Eigen::Vector2d rectified(std::size_t view, const Eigen::Vector2d& ideal_px) const {
    return (rectified_from_ideal[view] * ideal_px.homogeneous()).hnormalized();
  }
  /// Where the rectified left view shows a point in front of it.
  [[nodiscard]] Eigen::Vector2d rectified(const Eigen::Vector3d& x_in_local) const;
  /// Disparity of a point in front of the left camera.
  [[nodiscard]] double disparity_px(const Eigen::Vector3d& x_in_local) const {
    return focal_px * base_m / rectified_from_local.row(2).dot(x_in_local - left_centre_m);
  }
  /// The point at a pixel of the rectified left view with a disparity.
  [[nodiscard]] Eigen::Vector3d point_in_local(const Eigen::Vector2d& x_px, double d_px) const;
  /// Disparity at a pixel of the rectified left view if its ray ends at the given height.
  [[nodiscard]] double disparity_at_height_px(const Eigen::Vector2d& x_px,
                                              double z_in_local_m) const;
};

/// The rectification of a pair, for any rotation between the views. Nothing if a view looks along
/// the base, or nearly so, which means that the left image would grow to more than four times its
/// area.
/// @param size_px  size of the left image
std::optional<Rectification> rectification(const std::array<ProjectionMatrix, 2>& cameras,
                                           const cv::Size& size_px);

/// The pixel of an image that belongs to an ideal pixel, by iteration; not a number if the
/// distortion is not known there.
Eigen::Vector2d image_from_ideal(const PixelMap& ideal_from_image, const Eigen::Vector2d& ideal_px);

/// The pixels of an image that rectified pixels show, CV_32FC2 for cv::remap; bilinear between
/// every eighth one.
/// @param tile              box in rectified pixels
/// @param ideal_from_image  empty for an image without distortion
cv::Mat image_from_rectified(const Eigen::Matrix3d& rectified_from_ideal,
                             const PixelMap& ideal_from_image,
                             const cv::Rect& tile);

}  // namespace ridgeline::reconstruct
