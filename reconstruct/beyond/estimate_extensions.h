// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/options.h"
#include "reconstruct/geometry/flank_strips.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

#include <span>

namespace ridgeline::reconstruct {

/// What goes beyond the paper in the estimation, as the options switch it on: where uncertain lines end, depth_consensus
/// and network.
/// @param strips  beside each match (sample_flanks()), or none; must live as long as the result
EstimateExtensions estimate_extensions(const EstimationOptions& options,
                                       std::span<const FlankStrips> strips = {});

}  // namespace ridgeline::reconstruct
