// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/matching/match_scoring.h"
#include "reconstruct/geometry/segment.h"

#include <optional>

namespace ridgeline::evaluate {

/// The part of an edge alongside a segment, as ascending parameters of the edge.
struct Beside {
  int edge = 0;
  double from = 0.0, to = 0.0;
  double distance_px = 0.0;  ///< the larger of those at both ends
};

/// The part of the edge on which the segment lies; empty if it does not lie on the edge, see
/// score_matches().
std::optional<Beside> lies_on(const Segment2& segment, const Segment2& edge);

/// Whether the segment lies on the edge after extending the edge by its own length at both ends.
/// The reference does not say what is visible there.
bool continues(const Segment2& segment, const Segment2& edge);

/// Whether the segment is so close that it shows the edge itself rather than a shadow or gutter
/// along it.
bool is_certain(const Beside& beside);

}  // namespace ridgeline::evaluate
