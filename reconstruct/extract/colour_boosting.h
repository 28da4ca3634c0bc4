// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

namespace ridgeline::reconstruct {

/// The image in colour axes in which its derivatives have the same variance in all directions of
/// colour, without changing their sum (van de Weijer, Gevers & Bagdanov 2006): rare changes of hue
/// count as much as the frequent ones of brightness. The axes are those of the image's own
/// covariance of derivatives, for any set of bands. A direction of colour is enlarged by no more
/// than 10 against the strongest, as what is left there is noise. One band stays as it is.
/// `image`: CV_32FC(n), n = 1..4, not empty. The result has n bands too; its values have any range.
cv::Mat colour_boosted(const cv::Mat& image);

}  // namespace ridgeline::reconstruct
