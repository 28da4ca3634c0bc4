// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/line_match.h"
#include "reconstruct/views/match_view.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// How far beside the right segment of a match the right image shows the edge that the left one lies
/// on: an edge may have been found at one border of a road marking in one image and at the other border
/// in the other one, or at neither. Where both images show both surfaces beside a line, the colour
/// profiles across it are the same and tell (area-based matching, reduced to the one direction that a
/// line fixes). By match, pixels along n = (-u_y, u_x) of the right segment; 0 for matches up to
/// `max_angle_deg` to the epipolar line, without overlap or too near to the border, and where the
/// profiles agree as well as they are, or nowhere since the images show different surfaces.
/// Throws std::invalid_argument for other numbers of bands, std::out_of_range for an index that no
/// segment has.
std::vector<double> registered_shifts_px(const StereoPair& pair,
                                         std::span<const LineMatch> matches,
                                         double max_angle_deg);

}  // namespace ridgeline::reconstruct
