// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/line_tracer.h"
#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace ridgeline::reconstruct {

/// The pixels that lie farther than 6 px, the reach of flanks(), from pixels without data: CV_8UC1,
/// 0 for all others; empty if `is_valid` is.
/// @param is_valid  View::is_valid
cv::Mat far_from_no_data(const cv::Mat& is_valid);

/// Removes edges along the border of the data of an image, which are not edges of objects, and
/// shortens edges that run into it: an edge ends on data, and at least half of it lies on data.
/// Edges shorter than `min_length_px` are removed.
/// @param has_data  result of far_from_no_data(); if it is empty, all edges stay as they are
std::vector<EdgeTrace> edges_on_data(std::vector<EdgeTrace> edges,
                                     const cv::Mat& has_data,
                                     double min_length_px);

/// Removes the segments of which less than half lies on data.
/// @param has_data  as for edges_on_data()
void remove_edges_of_no_data(std::vector<EdgeSegment>& segments, const cv::Mat& has_data);

}  // namespace ridgeline::reconstruct
