// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace ridgeline::reconstruct {

/// Removes the segments that are the border of the data of an image and no edge of an object: more
/// than half of their length lies within 3 px of pixels without data, which is how far an edge
/// reaches in the gradient.
/// @param is_valid  View::is_valid; if it is empty, all segments stay
void remove_edges_of_no_data(std::vector<EdgeSegment>& segments, const cv::Mat& is_valid);

}  // namespace ridgeline::reconstruct
