// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace ridgeline::simulate {

/// A part of an image, or all of it.
struct ImageWindow {
  cv::Mat pixels;                                       ///< CV_8UC(n) or CV_16UC(n)
  Eigen::Vector2i corner_px = Eigen::Vector2i::Zero();  ///< its top-left pixel in the image
};

}  // namespace ridgeline::simulate
