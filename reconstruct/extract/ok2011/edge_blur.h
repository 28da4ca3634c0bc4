// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// Standard deviation, in pixels, assumed for the blur of an image's edges if it cannot be
/// measured: typical of aerial images.
inline constexpr double kTypicalBlur_px = 0.6;

/// Standard deviation of the blur of an image's edges, in pixels, from 0.35 to 6. It is the median
/// over the segments whose profile is described well by one blurred step; std::nullopt with fewer
/// than five such segments.
/// @param image  CV_32FC(n), n = 1..4
std::optional<double> edge_blur_px(const cv::Mat& image, std::span<const Segment2> segments);

/// edge_blur_px() of the longest segments.
std::optional<double> blur_of_longest_px(const cv::Mat& image,
                                         std::span<const EdgeSegment> segments);

}  // namespace ridgeline::reconstruct
