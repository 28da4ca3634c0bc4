// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/matching/match_scoring.h"
#include "reconstruct/geometry/segment.h"

#include <optional>

namespace ridgeline::evaluate {

/// Stretch of an edge that a segment runs beside, as parameters of the edge, ascending.
struct Beside {
  int edge = 0;
  double from = 0.0, to = 0.0;
  double distance_px = 0.0;  ///< the larger one of both ends
};

/// The stretch of the edge that the segment lies on; nothing unless it lies on the edge, see
/// score_matches().
std::optional<Beside> lies_on(const Segment2& segment, const Segment2& edge);

/// Whether the segment lies on the edge when this is extended by its own length at both ends. The
/// reference cannot tell what is visible there.
bool continues(const Segment2& segment, const Segment2& edge);

/// Whether the segment lies so close that it shows the edge and not a shadow or gutter along it.
bool is_certain(const Beside& beside);

}  // namespace ridgeline::evaluate
