// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/options.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Applies adjust_network() to the results of `joint` (Method::kNetwork), which also give the
/// support of aligned lines. A line is left unchanged if it has no geometry, if the network cannot
/// adjust it or hardly determines it, if it has no more accepted meetings than `joint` has points,
/// or if `joint` determines its height better.
/// @param lines     have covariances of the centroid form, whichever form `joint` used
/// @param by_track  the line of each track, or its parts
void adjust_together(const TrackedLines& lines,
                     std::span<const PairConnection> connections,
                     const EstimationOptions& options,
                     std::vector<std::vector<JointLine>>& by_track);

}  // namespace ridgeline::reconstruct
