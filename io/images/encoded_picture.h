// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <string>

namespace ridgeline::io {

/// The bytes of a PNG file. `picture`: CV_8UC1, or CV_8UC3 in OpenCV's band order (blue, green,
/// red); otherwise std::invalid_argument.
std::string png_bytes(const cv::Mat& picture);

/// The bytes of a JPEG file. `picture` as for png_bytes(); quality 1 to 100, otherwise
/// std::invalid_argument.
std::string jpeg_bytes(const cv::Mat& picture, int quality);

/// Decodes a JPEG file; bands as for jpeg_bytes(). Throws std::runtime_error for bytes that are not
/// JPEG.
cv::Mat decoded_jpeg(const std::string& bytes);

}  // namespace ridgeline::io
