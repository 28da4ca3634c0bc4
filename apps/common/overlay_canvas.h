// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace ridgeline::apps {

/// Fractional bits of the coordinates returned by on_canvas(), for OpenCV's `shift` argument.
inline constexpr int kCanvasFractionBits = 4;

/// An image to draw segments on: CV_8UC3 in OpenCV's band order (blue, green, red), showing the
/// first three bands, or the first one in grey, enlarged twice because segments may be 2 px apart.
/// `image`: CV_32FC(1..4), 0 dark .. 1 bright.
cv::Mat overlay_canvas(const cv::Mat& image);

/// Converts a pixel of the image to canvas coordinates, in 2^-kCanvasFractionBits display pixels.
cv::Point on_canvas(const Eigen::Vector2d& x_px);

}  // namespace ridgeline::apps
