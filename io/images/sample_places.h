// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/window.h"

#include <opencv2/core/types.hpp>

#include <vector>

namespace ridgeline::io {

/// Blocks of an image that represent it: at most 256 of 64 x 64 pixels, evenly distributed; all of
/// a small image in one.
std::vector<Window> sample_places(const cv::Size& size_px);

}  // namespace ridgeline::io
