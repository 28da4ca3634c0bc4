// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// Distance in pixels within which other pixels influence the gradient at a pixel.
int gradient_reach_px(double sigma_px);

/// The gradient of a multi-band image after Di Zenzo (1986): for each pixel, the direction in which
/// the bands together change most, i.e. the principal eigenvector of the tensor
/// G = sum over bands of grad f grad f^T, of length sqrt(lambda_1), in 1/px. The tensor is not
/// smoothed, because smoothing would shift edges at corners and towards close neighbours. The
/// derivatives are those of a Gaussian of `sigma_px`, exact on a linear ramp; the border is
/// replicated.
/// The gradient points towards the increasing mean of the bands; its sign is arbitrary where the
/// mean does not change. `image`: CV_32FC(n), n = 1..4. Returns CV_32FC2 (x, y).
cv::Mat colour_gradient(const cv::Mat& image, double sigma_px);

}  // namespace ridgeline::reconstruct
