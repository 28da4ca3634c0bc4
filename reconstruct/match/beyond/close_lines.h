// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/candidates.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line that runs beside another one at a few pixels.
struct CloseLine {
  int id = 0;
  Eigen::Vector2d towards;  ///< unit normal of the line, to the side on which the other one is
  double distance_px = 0.0;
};

/// The close lines of each segment.
using CloseLines = std::vector<std::vector<CloseLine>>;

/// The nearest line on each side of each segment, if one runs along at least half of it within 4.5
/// px.
CloseLines close_lines(std::span<const Segment2> segments);

/// Removes candidates that would exchange the two edges of a narrow strip. If both segments have a
/// line close by, on one side each, these must be the same side, because a gutter, a kerb or the
/// borders of a marking are seen in the same order from above.
void keep_order_of_close_lines(const SearchedPair& pair,
                               const std::array<CloseLines, 2>& close,
                               Candidates& candidates);

}  // namespace ridgeline::reconstruct
