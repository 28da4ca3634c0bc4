// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/flank_strips.h"
#include "reconstruct/beyond/options.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

#include <span>

namespace ridgeline::reconstruct {

/// What aligned matches rest on where their evidence agrees on the depth (agree_on_depth()): the lines that each shows,
/// mostly one, with the artificial points of it that agree, and where these fix no direction what both images show at
/// the ends or in the strips beside the line.
/// @param lines   must live as long as the result; so must the strips
/// @param direct  the lines by intersection of their planes: the ends of these are likely heights
/// @param strips  beside each match, or none (options.flanks)
/// Throws std::invalid_argument for strips of another number than the lines.
SupportOfMatch consensus_support(const StereoLines& lines,
                                 std::span<const ReconstructedLine> direct,
                                 std::span<const FlankStrips> strips,
                                 const EstimationOptions& options);

}  // namespace ridgeline::reconstruct
