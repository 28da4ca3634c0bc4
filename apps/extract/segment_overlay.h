// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace ridgeline::apps {

/// The image enlarged twice (CV_8UC3) with its segments in varying colours and dots at their ends.
/// `image`: CV_32FC(n) in [0, 1]; with fewer than 3 bands, the first one is shown in grey.
cv::Mat segment_overlay(const cv::Mat& image, const std::vector<EdgeSegment>& segments);

}  // namespace ridgeline::apps
