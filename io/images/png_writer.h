// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <string>

namespace ridgeline::io {

/// Writes a picture for display as PNG, completely or not at all. `picture`: CV_8UC1, or CV_8UC3 in
/// OpenCV's band order (blue, green, red); otherwise std::invalid_argument. Throws IoError if it
/// cannot be written.
void write_png(const std::string& path, const cv::Mat& picture);

}  // namespace ridgeline::io
