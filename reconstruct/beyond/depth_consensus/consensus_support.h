// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/options.h"
#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

#include <span>

namespace ridgeline::reconstruct {

/// Gives the support of aligned matches whose evidence agrees on the depth (agree_on_depth()). A match gives
/// the lines that it shows, mostly one, each with its artificial points that agree. Points on the surface
/// beside the line are added if it is known. Otherwise the ends of both segments are added if they agree and
/// the artificial points fix no direction.
/// @param lines    must live as long as the result; so must the surface
/// @param direct   the lines by intersection of their planes; their ends are likely heights
/// @param surface  the surface of the pair, or null (options.surface)
SupportOfMatch consensus_support(const StereoLines& lines,
                                 std::span<const ReconstructedLine> direct,
                                 const Surface* surface,
                                 const EstimationOptions& options);

}  // namespace ridgeline::reconstruct
