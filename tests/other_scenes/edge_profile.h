// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace ridgeline::other {

/// Where an image changes most across a segment, by its mean profile along the segment.
struct EdgeProfile {
  double offset_px = 0.0;    ///< of the strongest change from the segment, to both sides
  double contrast_grey = 0;  ///< change of colour over one pixel there, grey values of 0 to 255
};

/// Within `reach_px` to both sides. `image`: CV_8UC3. Nothing if the segment is shorter than 20 px
/// or not in the image.
std::optional<EdgeProfile> edge_profile(const cv::Mat& image,
                                        const Segment2& segment,
                                        double reach_px);

}  // namespace ridgeline::other
