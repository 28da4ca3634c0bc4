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

}  // namespace ridgeline::reconstruct
