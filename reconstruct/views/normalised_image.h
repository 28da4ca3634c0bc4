// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// An image of any radiometric depth brought to a common scale: CV_32FC(n) in [0, 1]. Each band is
/// stretched linearly so that its middle 99 % of values, widened by a quarter on each side where
/// the band has values there, fill [0, 1]; what lies beyond (hot pixels, glints) is clipped. A
/// linear stretch keeps edges where they are; clipping would move them, hence the margin. A
/// constant band becomes zeros.
/// `raw`: CV_8UC(n) or CV_16UC(n), n = 1..4, not empty; throws std::invalid_argument otherwise.
cv::Mat normalised_image(const cv::Mat& raw);

}  // namespace ridgeline::reconstruct
