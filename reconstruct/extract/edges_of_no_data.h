// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace ridgeline::reconstruct {

/// Removes segments along the border of the data of an image, which are not edges of objects: more
/// than half of their length lies within 3 px, the reach of an edge in the gradient, of pixels
/// without data.
/// @param is_valid  View::is_valid; if it is empty, all segments stay
void remove_edges_of_no_data(std::vector<EdgeSegment>& segments, const cv::Mat& is_valid);

}  // namespace ridgeline::reconstruct
