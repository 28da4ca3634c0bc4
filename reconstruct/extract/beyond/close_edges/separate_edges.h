// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/edge_segments.h"

#include <vector>

namespace ridgeline::reconstruct {

/// Replaces edges that are two edges blurred into one by these two (CloseEdgeFinder). If both had
/// been detected already, each stays once.
/// @param image  CV_32FC(n), n = 1..4, as the camera saw it: neither diffused nor boosted
std::vector<EdgeTrace> separate_edges(std::vector<EdgeTrace> edges, const cv::Mat& image);

}  // namespace ridgeline::reconstruct
