// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line that runs alongside a segment at a distance of a few pixels.
struct CloseLine {
  int id = 0;
  Eigen::Vector2d towards;  ///< unit normal of the segment, pointing to the side of this line
  double distance_px = 0.0;
};

/// The close lines of each segment.
using CloseLines = std::vector<std::vector<CloseLine>>;

/// The nearest line on each side of each segment, if one runs along at least half of it within 4.5
/// px.
CloseLines close_lines(std::span<const Segment2> segments);

}  // namespace ridgeline::reconstruct
