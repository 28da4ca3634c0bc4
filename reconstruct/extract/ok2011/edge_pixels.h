// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace ridgeline::reconstruct {

/// A pixel at which the gradient has a maximum across an edge.
struct EdgePixel {
  int x = 0, y = 0;
  Eigen::Vector2f position_px;  ///< position of the maximum, less than a pixel from (x, y)
  Eigen::Vector2f gradient;     ///< gradient at (x, y), 1/px
};

/// Offset in pixels, in [-0.5, 0.5], of the maximum of the parabola through the logarithms of three
/// equally spaced strengths, relative to the middle one. It is exact for the profile of a blurred
/// step, a Gaussian, at any position between the pixels and along either axis.
float peak_offset_px(float before, float middle, float after);

/// The edge pixel at (x, y), if the gradient there has a maximum along the axis (x or y) closest to
/// its direction (Devernay 1995) and is stronger than `min_strength`. The pixel must not be on the
/// border of `gradient` (CV_32FC2 from colour_gradient()).
std::optional<EdgePixel> edge_pixel_at(const cv::Mat& gradient, int x, int y, float min_strength);

}  // namespace ridgeline::reconstruct
