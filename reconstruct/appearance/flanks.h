// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <array>

namespace ridgeline::reconstruct {

/// Mean colour of the strips left and right of a segment, from 1 px to 6 px beside it; left is the
/// side that n = (-u_y, u_x) points away from (y runs down). Samples outside of the image are left
/// out; a strip without any sample is black.
/// `image`: CV_32FC(n), n = 1..4.
/// `scale_px`: the strips are this many times as wide and as far away, see EdgeSegment::scale_px
std::array<Flank, 2> flanks(const cv::Mat& image, const Segment2& in_image, double scale_px = 1.0);

/// Gives a segment with ends and scale its flanks, and turns it so that the brighter one is on the
/// right.
void set_flanks(const cv::Mat& image, EdgeSegment& segment);

}  // namespace ridgeline::reconstruct
