// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <opencv2/core/mat.hpp>

namespace ridgeline::simulate {

/// Mean difference of the two sides of a segment in the band where it is largest, as a share of the image's range.
/// `image`: CV_8UC(n) or CV_16UC(n).
double contrast_across(const cv::Mat& image, const Segment2& segment_px);

}  // namespace ridgeline::simulate
