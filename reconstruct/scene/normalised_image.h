// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace ridgeline::reconstruct {

/// Of each band the value that becomes 0 and the one that becomes 1. A band whose two values are
/// equal becomes zeros.
using BandRanges = std::vector<std::array<double, 2>>;

/// The stretch by which the middle 99 % of the values of each band, widened by a quarter on each
/// side where the band has values there, fill [0, 1]. `raw`: CV_8UC(n) or CV_16UC(n), n = 1..4, not
/// empty; throws std::invalid_argument otherwise.
BandRanges band_ranges(const cv::Mat& raw);

/// An image of any radiometric depth brought to a common scale: CV_32FC(n) in [0, 1]. What lies
/// beyond the stretch (hot pixels, glints) is clipped. A linear stretch keeps edges where they are;
/// clipping would move them, hence the margin of band_ranges(). Throws std::invalid_argument as
/// band_ranges(), and unless there is a range for each band.
cv::Mat stretched_image(const cv::Mat& raw, const BandRanges& ranges);

/// The image by the stretch of all of its pixels.
cv::Mat normalised_image(const cv::Mat& raw);

}  // namespace ridgeline::reconstruct
