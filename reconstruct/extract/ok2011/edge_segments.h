// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/line_tracer.h"
#include "reconstruct/extract/ok2011/options.h"
#include "reconstruct/geometry/edge_segment.h"

#include <vector>

namespace ridgeline::reconstruct {

/// The segments of edges: lines in the pixels of the file and in ideal pixels, their uncertainty,
/// flanks, contrast and direction. Edges of which a part has no ideal pixel are left out.
std::vector<EdgeSegment> edge_segments(const std::vector<EdgeTrace>& edges,
                                       const cv::Mat& image,
                                       const PixelMap& ideal_from_image,
                                       const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
