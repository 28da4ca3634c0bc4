// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace ridgeline::reconstruct {

/// One image of a pair as the matching sees it.
struct MatchView {
  ProjectionMatrix image_from_local;  ///< local frame -> ideal pixel
  cv::Mat image;                      ///< CV_32FC(1..4), 0 dark .. 1 bright
  std::vector<EdgeSegment> segments;
};

/// Throws std::invalid_argument unless both images are CV_32F of 1 to 4 bands, the same number in
/// both, and at least 2 x 2 pixels.
void check_images(const MatchView& left, const MatchView& right);

/// The segments in ideal pixels.
std::vector<Segment2> ideal_segments(const MatchView& view);

}  // namespace ridgeline::reconstruct
