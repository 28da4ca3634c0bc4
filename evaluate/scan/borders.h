// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/border_line.h"
#include "evaluate/scan/scan_region.h"
#include "evaluate/scan/seams.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// A straight part of the border of a region, in its plane; the region lies to its left.
struct Border {
  Segment2 uv_m;
  BorderLine line;  ///< in the frame of the segment: s from its start, t to its right
  double support = 0.0;
  double off_axis_rad = 0.0;  ///< from the direction that its borders usually have, if any
};

/// The straight parts of a region's border that are no seams, in the order of its loops.
/// @param seams  of this region, in its plane
std::vector<Border> find_borders(const ScanRegion& region, std::span<const Segment2> seams);

/// The share of a line's length with points within reach along it; x of the points is the place.
double supported_share(std::span<const Eigen::Vector2d> st_m, double length_m, double reach_m);

/// Whether a place in the plane of a region belongs to one of its seams.
bool is_next_to_seam(const Eigen::Vector2d& x, std::span<const Segment2> seams, double reach_m);

}  // namespace ridgeline::evaluate
