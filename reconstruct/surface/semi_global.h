// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/disparity_ranges.h"

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// Disparities of the pixels of a rectified view by semi-global matching along eight paths
/// (Hirschmueller 2008), each within the range of its cell. CV_32F, with subpixel accuracy by a
/// parabola through the costs. A disparity is negative if it is unknown: two disparities fit about
/// equally well, the check from right to left fails, the best one is at an end of its range (unless
/// that is 0 or n_all - 1), or the range is empty. The costs are those of MatchingCost.
/// @param left   CV_8UC1 or CV_8UC3, of the size of the ranges
/// @param right  the same rows and bands, `n_all` columns wider; column x of the left view
///               corresponds to column x + n_all - d at disparity d
cv::Mat semi_global_disparities(const cv::Mat& left,
                                const cv::Mat& right,
                                const DisparityRanges& ranges);

}  // namespace ridgeline::reconstruct
