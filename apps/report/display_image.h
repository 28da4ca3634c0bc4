// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::apps {

/// A normalised image for a browser: 8 bits, its first three bands or the first one in grey, at
/// most about a megapixel.
cv::Mat display_image(const cv::Mat& normalised);

}  // namespace ridgeline::apps
