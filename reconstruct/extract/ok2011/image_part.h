// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <utility>

namespace ridgeline::reconstruct {

/// An image and its position in the frame from which it is cut. By default, the image is the whole
/// frame.
struct ImagePart {
  cv::Mat pixels;         ///< CV_32FC(n) from normalised_image() or stretched_image(), n = 1..4
  cv::Point corner_px{};  ///< position of its first pixel in the frame

  ImagePart(cv::Mat image, const cv::Point& corner = {})  // NOLINT(google-explicit-constructor)
      : pixels(std::move(image)), corner_px(corner) {}
};

}  // namespace ridgeline::reconstruct
