// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace ridgeline::reconstruct {

/// For each band, the values that are mapped to 0 and 1. A band whose two values are equal becomes
/// zero everywhere.
using BandRanges = std::vector<std::array<double, 2>>;

/// The ranges that are stretched to [0, 1]: the middle 99 % of the values of each band, widened on
/// each side by a quarter of its width, but not beyond the smallest and largest value of the band.
/// `raw`: CV_8UC(n) or CV_16UC(n), n = 1..4, not empty; throws std::invalid_argument otherwise.
BandRanges band_ranges(const cv::Mat& raw);

/// Brings an image of any radiometric depth to a common scale: CV_32FC(n) in [0, 1]. Values outside
/// the ranges (hot pixels, glints) are clipped. A linear stretch keeps edges where they are,
/// whereas clipping would move them; hence the margin of band_ranges(). Throws
/// std::invalid_argument under the same conditions as band_ranges(), and unless there is one range
/// for each band.
cv::Mat stretched_image(const cv::Mat& raw, const BandRanges& ranges);

/// The image stretched by the ranges of all its pixels.
cv::Mat normalised_image(const cv::Mat& raw);

}  // namespace ridgeline::reconstruct
