// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/edge_segments.h"

#include <vector>

namespace ridgeline::reconstruct {

/// Replaces each edge that consists of two edges blurred into one by these two edges
/// (CloseEdgeFinder). Edges that are then found twice are kept only once.
/// @param image  CV_32FC(n), n = 1..4, as recorded by the camera: neither diffused nor sharpened
std::vector<EdgeTrace> separate_edges(std::vector<EdgeTrace> edges, const cv::Mat& image);

}  // namespace ridgeline::reconstruct
