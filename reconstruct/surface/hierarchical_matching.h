// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/disparity_ranges.h"

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// Disparities within [0, n_all) by semi_global_disparities(). All of them are searched in images
/// of a quarter of the size, where that takes a 64th of the time; a pixel of larger images only
/// searches near what the images of half their size know (Rothermel et al. 2012). Views of less
/// than 64 pixels have fewer smaller images.
/// @param n_all  a multiple of kHierarchicalStep
/// Views and result as for semi_global_disparities().
cv::Mat hierarchical_disparities(const cv::Mat& left, const cv::Mat& right, int n_all);

inline constexpr int kHierarchicalStep = 4 * DisparityRange::kStep;

}  // namespace ridgeline::reconstruct
