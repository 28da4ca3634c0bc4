// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

/// A pair of views rotated so that corresponding pixels lie in the same row, further left in the
/// right view by the disparity d > 0. Both rotated cameras have the same axes, focal length and
/// principal point; rows run along the base. Rectified pixels are about as large as the pixels at
/// the middle of the left image.
struct Rectification {
  std::array<Eigen::Matrix3d, 2> rectified_from_ideal;  ///< homographies of the views
  Eigen::Matrix3d rectified_from_local;                 ///< rotation of the axes
  Eigen::Vector3d left_centre_m;
  Eigen::Vector2d principal_point_px;
  double focal_px = 0.0, base_m = 0.0;
  cv::Size size;  ///< bounding box of the left image, from (0, 0)

  [[nodiscard]] Eigen::Vector2d rectified(std::size_t view, const Eigen::Vector2d& ideal_px) const {
    return (rectified_from_ideal[view] * ideal_px.homogeneous()).hnormalized();
  }
  /// Pixel of the rectified left view for a point in front of it.
  [[nodiscard]] Eigen::Vector2d rectified(const Eigen::Vector3d& x_in_local) const;
  /// Disparity of a point in front of the left camera.
  [[nodiscard]] double disparity_px(const Eigen::Vector3d& x_in_local) const {
    return focal_px * base_m / rectified_from_local.row(2).dot(x_in_local - left_centre_m);
  }
  /// The object point at a pixel of the rectified left view with the given disparity.
  [[nodiscard]] Eigen::Vector3d point_in_local(const Eigen::Vector2d& x_px, double d_px) const;
  /// Disparity at a pixel of the rectified left view if its ray ends at the given height.
  [[nodiscard]] double disparity_at_height_px(const Eigen::Vector2d& x_px,
                                              double z_in_local_m) const;
};

/// The rectification of a pair, for any rotation between the views. std::nullopt if the views look
/// nearly along the base, or if the left image would reach the horizon of the base or grow to more
/// than four times its area.
/// @param size_px  size of the left image
std::optional<Rectification> rectification(const std::array<ProjectionMatrix, 2>& cameras,
                                           const cv::Size& size_px);

/// The pixel of an image that corresponds to an ideal pixel, computed by iteration; NaN if the
/// distortion is not known there.
Eigen::Vector2d image_from_ideal(const PixelMap& ideal_from_image, const Eigen::Vector2d& ideal_px);

/// The image pixels that correspond to rectified pixels, CV_32FC2 for cv::remap; computed for every
/// eighth pixel in x and y and interpolated bilinearly in between.
/// @param tile              box in rectified pixels
/// @param ideal_from_image  empty for an image without distortion
cv::Mat image_from_rectified(const Eigen::Matrix3d& rectified_from_ideal,
                             const PixelMap& ideal_from_image,
                             const cv::Rect& tile);

}  // namespace ridgeline::reconstruct
