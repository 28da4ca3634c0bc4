// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/disparity_ranges.h"

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// Disparities within [0, n_all) by semi_global_disparities(). The full range is searched only in
/// images reduced to a quarter of the size, which takes a 64th of the time; in larger images, each
/// pixel is searched only near the disparities found at half the size (Rothermel et al. 2012).
/// Views of less than 64 pixels are reduced less often.
/// @param n_all  a multiple of kHierarchicalStep
/// Views and result as for semi_global_disparities().
cv::Mat hierarchical_disparities(const cv::Mat& left, const cv::Mat& right, int n_all);

inline constexpr int kHierarchicalStep = 4 * DisparityRange::kStep;

}  // namespace ridgeline::reconstruct
