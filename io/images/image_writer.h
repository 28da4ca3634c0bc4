// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <string>

namespace ridgeline::io {

/// Writes an image as TIFF (deflate with a predictor, tiles of no more than the image, bands
/// interleaved), whole or not at all. `image`: CV_8UC(n) or CV_16UC(n), n = 1..4, the bands in the
/// order of the file. Throws IoError if it cannot be written, std::invalid_argument for another
/// type or an empty image.
void write_tiff(const std::string& path, const cv::Mat& image);

}  // namespace ridgeline::io
