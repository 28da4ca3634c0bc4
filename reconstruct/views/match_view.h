// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/views/epipolar_transfer.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <vector>

namespace ridgeline::reconstruct {

/// One image of a pair as the matching sees it.
struct MatchView {
  ProjectionMatrix image_from_local;  ///< local frame -> ideal pixel
  cv::Mat image;                      ///< CV_32FC(1..4), 0 dark .. 1 bright
  std::vector<EdgeSegment> segments;
  PixelMap ideal_from_image{};
};

/// A pair of views ready to be matched.
struct StereoPair {
  std::array<MatchView, 2> views;  ///< left (base), right
  std::array<double, 2> height_range_in_local_m{};

  [[nodiscard]] std::array<ProjectionMatrix, 2> cameras() const {
    return {views[0].image_from_local, views[1].image_from_local};
  }
};

/// A pair with what it takes to find in one view what the other one shows.
struct SearchedPair {
  const MatchView& left;
  const MatchView& right;
  StereoSearch search;
};

/// Throws std::invalid_argument as StereoSearch, and unless both images are CV_32F of 1 to 4 bands, the same number in
/// both, and at least 2 x 2 pixels.
SearchedPair searched(const StereoPair& pair);

/// The segments in ideal pixels.
std::vector<Segment2> ideal_segments(const MatchView& view);

}  // namespace ridgeline::reconstruct
