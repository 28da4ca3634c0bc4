// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace ridgeline::apps {

/// Fraction bits of the coordinates that on_canvas() gives and OpenCV draws at (its `shift`).
inline constexpr int kCanvasFractionBits = 4;

/// An image to draw segments on: CV_8UC3 in OpenCV's order of bands (blue, green, red), the first
/// three bands or the first one in grey, enlarged twice because segments may lie 2 px apart.
/// `image`: CV_32FC(1..4), 0 dark .. 1 bright.
cv::Mat overlay_canvas(const cv::Mat& image);

/// A pixel of the image on its canvas, in 2^-kCanvasFractionBits display pixels.
cv::Point on_canvas(const Eigen::Vector2d& x_px);

}  // namespace ridgeline::apps
