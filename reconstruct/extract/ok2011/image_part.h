// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <utility>

namespace ridgeline::reconstruct {

/// An image, and where it lies in the frame that it is cut from. An image alone is a frame of its
/// own.
struct ImagePart {
  cv::Mat pixels;         ///< CV_32FC(n) of normalised_image() or stretched_image(), n = 1..4
  cv::Point corner_px{};  ///< the place of its first pixel in the frame

  ImagePart(cv::Mat image, const cv::Point& corner = {})  // NOLINT(google-explicit-constructor)
      : pixels(std::move(image)), corner_px(corner) {}
};

}  // namespace ridgeline::reconstruct
