// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/line_tracer.h"
#include "reconstruct/extract/ok2011/options.h"
#include "reconstruct/geometry/edge_segment.h"

#include <vector>

namespace ridgeline::reconstruct {

/// Computes the segments of edges: lines in file pixels and in ideal pixels, with uncertainty,
/// flanks, contrast and direction. Edges are left out if any of their samples has no ideal pixel.
std::vector<EdgeSegment> edge_segments(const std::vector<EdgeTrace>& edges,
                                       const cv::Mat& image,
                                       const PixelMap& ideal_from_image,
                                       const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
