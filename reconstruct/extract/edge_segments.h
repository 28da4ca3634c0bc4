// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/extract_segments.h"
#include "reconstruct/extract/line_tracer.h"

#include <vector>

namespace ridgeline::reconstruct {

/// The segments of traced edges: regression lines in the pixels of the file and in ideal pixels,
/// their uncertainty, flanks, contrast and direction. Traces of which a sample has no ideal pixel
/// are left out.
std::vector<EdgeSegment> edge_segments(const std::vector<EdgeTrace>& traces,
                                       const cv::Mat& image,
                                       const PixelMap& ideal_from_image);

}  // namespace ridgeline::reconstruct
