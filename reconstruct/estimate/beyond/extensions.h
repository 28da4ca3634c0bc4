// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/options.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/surface/surface.h"

namespace ridgeline::reconstruct {

/// The extensions of the estimation that the options switch on (common_part and consensus), and the
/// network adjustment.
/// @param surface_of  the surfaces of the pairs; they must live as long as the result
EstimateExtensions estimate_extensions(const EstimationOptions& options,
                                       const SurfaceOf& surface_of = no_surface);

}  // namespace ridgeline::reconstruct
