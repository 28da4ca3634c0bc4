// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/extract_segments.h"
#include "reconstruct/extract/line_tracer.h"

#include <vector>

namespace ridgeline::reconstruct {

/// An edge as a detector found it.
struct DetectedEdge {
  EdgeTrace trace;
  /// The detector's own line, in pixels of the file; else it is the regression line of the trace.
  std::optional<Segment2> segment;
};

/// The segments of edges: lines in the pixels of the file and in ideal pixels, their uncertainty,
/// flanks, contrast and direction. Edges of which a part has no ideal pixel are left out.
std::vector<EdgeSegment> edge_segments(const std::vector<DetectedEdge>& edges,
                                       const cv::Mat& image,
                                       const PixelMap& ideal_from_image,
                                       const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
