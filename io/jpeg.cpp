// SPDX-License-Identifier: BSD-3-Clause
#include "io/jpeg.h"

#include "reconstruct/geometry/check.h"

#include <opencv2/imgcodecs.hpp>

#include <stdexcept>
#include <vector>

namespace ridgeline::io {

std::string jpeg_bytes(const cv::Mat& picture, int quality) {
  check(!picture.empty() && (picture.type() == CV_8UC1 || picture.type() == CV_8UC3),
        "jpeg_bytes: OpenCV type ", picture.type(), ", must be CV_8UC1 or CV_8UC3 and not empty");
  check(quality >= 1 && quality <= 100, "jpeg_bytes: quality = ", quality, ", must be in [1, 100]");
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, quality})) {
    throw std::runtime_error("a picture could not be encoded as JPEG");
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace ridgeline::io
