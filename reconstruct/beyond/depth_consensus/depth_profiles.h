// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/depth_scorer.h"

#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// One line: through any two pieces of evidence, the horizontal one through each, and those that the
/// strips beside the match speak for. Prior
///     log(h * b(slope / sigma_slope) + (1 - h) * r(slope))      h the share of horizontal lines,
/// with r the slopes of roofs, and of streets.
std::vector<DepthProfile> straight_profiles(const DepthQuestion& question,
                                            const DepthScorer& scorer);

/// The two verges of a gable: up to a point where the line may be cut and down again as steeply, the
/// slope by any other evidence. Prior gable_share * r(slope).
std::vector<DepthProfile> gable_profiles(const DepthQuestion& question, const DepthScorer& scorer);

/// The best row of horizontal lines at different heights, cut where the line may be. Prior step_share
/// for the first cut, more for those after it, and steps of a metre or less. Empty without a place to
/// cut that leaves steps of 15 px.
std::optional<DepthProfile> row_profile(const DepthQuestion& question, const DepthScorer& scorer);

}  // namespace ridgeline::reconstruct
