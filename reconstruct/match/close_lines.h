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

/// By segment: the nearest line close by on each side, if any.
std::vector<std::vector<CloseLine>> close_lines(std::span<const Segment2> segments);

/// Takes candidates away that would exchange the two edges of a narrow strip.
///
/// - Where both segments have a line close by, on one side each, it is the same side: a gutter, a
///   kerb, both borders of a marking are seen in the same order from above.
/// - Where only one of them has, it is seen by one camera only: a strip of wall or fascia below the
///   edge of a roof. Whatever is vertical appears with its upper edge farther from the nadir; the
///   other camera, which does not see the strip, sees that upper edge. Its lower edge loses a
///   candidate that the upper edge has as well.
void keep_order_of_close_lines(const MatchView& left,
                               const MatchView& right,
                               const StereoSearch& search,
                               std::vector<std::vector<Candidate>>& candidates);

}  // namespace ridgeline::reconstruct
