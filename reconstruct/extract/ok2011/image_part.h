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
  /// CV_8UC1, 0 for pixels without data and those whose gradient they affect; empty if there are
  /// none.
  cv::Mat has_data{};

  ImagePart(cv::Mat image,  // NOLINT(google-explicit-constructor)
            const cv::Point& corner = {},
            cv::Mat data = {})
      : pixels(std::move(image)), corner_px(corner), has_data(std::move(data)) {}
};

}  // namespace ridgeline::reconstruct
