// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/surface/surface.h"

#include <span>

namespace ridgeline::reconstruct {

/// Adds the evidence of the surfaces beside each left segment (sides_along()) to the log odds of
/// its candidates.
///
/// An edge lies on one of the surfaces beside it, mostly at the border of the one nearer to the
/// camera; a shadow or the foot of a wall lies on the farther one. A candidate implies a disparity
/// of the line in each piece. z^2 is the mean square of its misfits to the side with which it
/// agrees better, in combined standard deviations of surface and edge:
///
///     log_odds = log(0.1 + 2.7 exp(-z^2 / 2))
///
/// Agreement is about three times as frequent among correct candidates as among others,
/// contradiction a tenth as frequent. If one side is not trusted, the line may lie on it, so the
/// other side alone cannot contradict a candidate. The values were calibrated on training villages
/// and scenes of another renderer; 0.1 to 0.2 and 2.7 to 5 work equally well.
/// @param left  segments of the left view in ideal pixels, as many as `candidates`
void weigh_by_surface(const Surface& surface,
                      std::span<const Segment2> left,
                      Candidates& candidates);

}  // namespace ridgeline::reconstruct
