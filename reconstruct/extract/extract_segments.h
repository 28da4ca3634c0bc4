// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/options.h"
#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The ideal (undistorted) pixel of a pixel of the file, or nothing outside of the field for which
/// the distortion is known. Empty: they are the same.
using PixelMap = std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d&)>;

/// The straight edges of an image with their uncertainty (Ok et al. 2011, section 2), in a
/// fixed order. An image without texture has none.
/// `image`: CV_32FC(n) of normalised_image(), n = 1..4, not empty. Throws std::invalid_argument
/// for another type and for options out of range.
std::vector<EdgeSegment> extract_segments(const cv::Mat& image,
                                          const PixelMap& ideal_from_image = {},
                                          const ExtractOptions& options = {});

}  // namespace ridgeline::reconstruct
