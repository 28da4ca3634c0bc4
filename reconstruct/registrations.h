// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/options.h"
#include "reconstruct/estimate/tracked_lines.h"
#include "reconstruct/scene/scene.h"

#include <vector>

namespace ridgeline::reconstruct {

/// The corrected positions of the edges of each track and their uncertainty, as required by the
/// options: from the profiles across the edges (compare_profiles(), own_sigma_scale()), then from
/// how well the edges agree (agreement_sigma_scale()). One per track; empty if there are no tracks
/// or the options require neither.
/// @param scene    its views have images
/// @param tracked  without registrations
std::vector<Registrations> registrations_of(const Scene& scene,
                                            TrackedSegments tracked,
                                            const EstimationOptions& options);

}  // namespace ridgeline::reconstruct
