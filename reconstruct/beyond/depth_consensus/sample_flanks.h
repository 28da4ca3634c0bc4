// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/flank_strips.h"
#include "reconstruct/geometry/line_match.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The strips beside the matches up to `max_angle_deg` to the epipolar line, by match; empty ones
/// beside the others.
/// @param cameras              image_from_local, of ideal pixels
/// @param images               CV_32FC(1..4), the same number of bands in both
/// @param height_range_m       in the local frame; how far beyond its segment the right strip reaches
std::vector<FlankStrips> sample_flanks(const std::array<ProjectionMatrix, 2>& cameras,
                                       const std::array<cv::Mat, 2>& images,
                                       const std::array<std::vector<EdgeSegment>, 2>& segments,
                                       std::span<const LineMatch> matches,
                                       const std::array<double, 2>& height_range_m,
                                       double max_angle_deg);

}  // namespace ridgeline::reconstruct
