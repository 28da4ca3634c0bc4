// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <array>

namespace ridgeline::reconstruct {

/// Mean colour of the strips left and right of a segment, at distances from 1 px to 6 px; left is
/// the side from which n = (-u_y, u_x) points away (y runs down). Samples outside the image are
/// left out; a strip without samples is black.
/// `image`: CV_32FC(n), n = 1..4.
/// `scale_px`: factor for the width and distance of the strips; see EdgeSegment::scale_px
std::array<Flank, 2> flanks(const cv::Mat& image, const Segment2& in_image, double scale_px = 1.0);

/// Computes the flanks of a segment from its ends and scale, and reverses the segment if necessary
/// so that its brighter flank is on the right.
void set_flanks(const cv::Mat& image, EdgeSegment& segment);

}  // namespace ridgeline::reconstruct
