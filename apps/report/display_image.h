// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::apps {

/// Converts a normalised image for display in a browser: 8 bits, its first three bands or, in grey,
/// its first band, at most about a megapixel.
cv::Mat display_image(const cv::Mat& normalised);

}  // namespace ridgeline::apps
