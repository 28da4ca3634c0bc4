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
std::array<Flank, 2> flanks(const cv::Mat& image, const Segment2& in_image);

}  // namespace ridgeline::reconstruct
