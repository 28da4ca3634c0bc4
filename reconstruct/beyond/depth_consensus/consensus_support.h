// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/options.h"
#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

#include <span>

namespace ridgeline::reconstruct {

/// What aligned matches rest on where their evidence agrees on the depth (agree_on_depth()): the lines that each shows,
/// mostly one, with the artificial points of it that agree, and where these fix no direction what both images show at
/// the ends, or where the surface beside the line is.
/// @param lines   must live as long as the result; so must the surface
/// @param direct  the lines by intersection of their planes: the ends of these are likely heights
/// @param surface  of the pair, or none (options.surface)
SupportOfMatch consensus_support(const StereoLines& lines,
                                 std::span<const ReconstructedLine> direct,
                                 const Surface* surface,
                                 const EstimationOptions& options);

}  // namespace ridgeline::reconstruct
