// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/image_sampler.h"
#include "reconstruct/geometry/edge_segment.h"

#include <Eigen/Core>

#include <vector>

namespace ridgeline::reconstruct {

/// A point of an edge in its image.
struct EdgePoint {
  int step = 0;          ///< along the segment; points of successive steps are neighbours
  Eigen::Vector2d x_px;  ///< ideal pixel
};

/// The points of an edge, one for each pixel of its length from start to end. Each point lies where
/// the gradient across the segment is strongest within 1.5 px of it, to a fraction of a pixel. A
/// segment only keeps its regression line, so the points are found again. Steps without a maximum
/// and steps at the border of the image are left out.
std::vector<EdgePoint> edge_points(const ImageSampler& image, const EdgeSegment& edge);

}  // namespace ridgeline::reconstruct
