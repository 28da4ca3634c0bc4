// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/flank_strips.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/views/match_view.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The strips beside the matches up to `max_angle_deg` to the epipolar line, by match; empty ones
/// beside the others.
std::vector<FlankStrips> sample_flanks(const StereoPair& pair,
                                       std::span<const LineMatch> matches,
                                       double max_angle_deg);

}  // namespace ridgeline::reconstruct
