// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <optional>
#include <string>

namespace ridgeline::apps {

/// Warns if pixels that are black (0) in all bands and connected to the border of an image cover
/// more than 2 % of it: the frame of a turned or undistorted image has no data there, but its file
/// does not state this.
/// @param image     View::image
/// @param is_valid  View::is_valid
std::optional<std::string> black_border(const std::string& path,
                                        const cv::Mat& image,
                                        const cv::Mat& is_valid);

}  // namespace ridgeline::apps
