// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/surface/surface.h"

#include <span>

namespace ridgeline::reconstruct {

/// Adds to the log-odds of each left segment's candidates what the surfaces beside the segment tell
/// (sides_along()).
///
/// An edge lies on one of the surfaces beside it, mostly at the end of the nearer one; a shadow or
/// the foot of a wall lies on the farther one. A candidate gives the line a disparity in each
/// piece. z^2 is the mean square of its misfits to the side that it agrees with better, in standard
/// deviations of surface and edge:
///
///     log_odds = log(0.1 + 2.7 exp(-z^2 / 2))
///
/// Agreement is about three times as frequent among right candidates as among others, contradiction
/// a tenth as frequent. If one side is not trusted, the line may lie on it, so the other side alone
/// cannot contradict. The values were calibrated on training villages and scenes of another
/// renderer; 0.1 to 0.2 and 2.7 to 5 do as well.
/// @param left  segments of the left view in ideal pixels, as many as `candidates`
void weigh_by_surface(const Surface& surface,
                      std::span<const Segment2> left,
                      Candidates& candidates);

}  // namespace ridgeline::reconstruct
