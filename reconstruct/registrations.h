// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/options.h"
#include "reconstruct/estimate/tracked_lines.h"
#include "reconstruct/scene/scene.h"

#include <vector>

namespace ridgeline::reconstruct {

/// Where the edges of each track really are and how certain that is, as the options say: by the
/// profiles across them (compare_profiles(), own_sigma_scale()), then by how well they agree
/// (agreement_sigma_scale()). One per track; empty if there are no tracks or the options ask for
/// neither.
/// @param scene    its views have images
/// @param tracked  without registrations
std::vector<Registrations> registrations_of(const Scene& scene,
                                            TrackedSegments tracked,
                                            const EstimationOptions& options);

}  // namespace ridgeline::reconstruct
