// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/options.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/surface/surface.h"

#include <span>

namespace ridgeline::reconstruct {

/// Determines the support of aligned tracks whose evidence agrees on the depth (agree_on_depth()).
/// A track yields the lines that it supports, usually one, each with the artificial points that
/// agree. Points on the surface next to the line are added if the surface is known. Otherwise the
/// ends of both segments are added if they agree and the points do not determine a direction.
/// @param lines       must live as long as the result; so must the surfaces
/// @param direct      the lines from `direct`; their ends give likely heights
/// @param surface_of  the surfaces of the pairs (options.surface)
SupportOfTrack consensus_support(const TrackedLines& lines,
                                 std::span<const ReconstructedLine> direct,
                                 const SurfaceOf& surface_of,
                                 const EstimationOptions& options);

}  // namespace ridgeline::reconstruct
