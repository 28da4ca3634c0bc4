// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/depth_consensus/depth_scorer.h"

#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// Profiles of one line: the line through any two pieces of evidence, the horizontal line through
/// each, and the lines that the surfaces beside the track make likely. The prior is
///     log(h * b(slope / sigma_slope) + (1 - h) * r(slope)),
/// where h is the share of horizontal lines and r the distribution of the slopes of roofs and of
/// streets.
std::vector<DepthProfile> straight_profiles(const DepthQuestion& question,
                                            const DepthScorer& scorer);

/// Profiles of the two verges of a gable. They rise to a point where the track may be cut and fall
/// again equally steeply; any other piece of evidence gives the slope. The prior is gable_share *
/// r(slope), times a normal distribution of the height difference between the two feet.
std::vector<DepthProfile> gable_profiles(const DepthQuestion& question, const DepthScorer& scorer);

/// The best row of horizontal lines at different heights, cut where the track may be cut. The prior
/// is step_share for the first cut and larger for further ones; steps of a metre or less in height
/// are preferred. Empty if no cut leaves steps at least 15 px long.
std::optional<DepthProfile> row_profile(const DepthQuestion& question, const DepthScorer& scorer);

}  // namespace ridgeline::reconstruct
