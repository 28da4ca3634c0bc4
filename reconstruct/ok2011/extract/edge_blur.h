// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <opencv2/core/mat.hpp>

#include <span>

namespace ridgeline::reconstruct {

/// Standard deviation of the blur of an image's edges, in pixels. It is the median over the segments whose
/// profile is best described by one blurred step. With fewer than five such segments, it is the value that is
/// typical of aerial images.
/// @param image  CV_32FC(n), n = 1..4
double edge_blur_px(const cv::Mat& image, std::span<const Segment2> segments);

}  // namespace ridgeline::reconstruct
