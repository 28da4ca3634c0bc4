// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// Width in pixels of the margin around a block that influences the diffused values of the block.
int diffusion_reach_px(int levels);

/// Non-linear diffusion of a multi-band image (Perona & Malik 1990; Catte et al. 1992): du/dt =
/// div(g grad u), where all bands share one diffusivity g(s), with s the strength of the colour
/// gradient over all bands, so that an edge in one band is not blurred in another. g is Tukey's
/// biweight (Black et al. 1998), which is 0 for s >= lambda, so that stronger edges are preserved.
/// The diffusion runs in levels from coarse to fine, following Ok et al. (2010): the smoothing of s
/// decreases and lambda increases. Its explicit steps of 0.2 are stable for 4 neighbours; there is
/// no flux across the border. `image`: CV_32FC(n); `lambda`: CV_32FC1 of the first level, in 1/px;
/// `levels`: 1 to 3.
cv::Mat colour_diffusion(const cv::Mat& image, const cv::Mat& lambda, int levels);

}  // namespace ridgeline::reconstruct
