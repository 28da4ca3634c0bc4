// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/options.h"
#include "reconstruct/ok2011/match/match_extensions.h"

namespace ridgeline::reconstruct {

/// What goes beyond the paper in the matching, as the options switch it on: matched_radiometry, hidden_walls,
/// close_edges (the order of close lines).
/// @param candidates  of the first search, which gives the radiometry
MatchExtensions match_extensions(const MatchExtensionOptions& options,
                                 const CandidateOptions& candidates);

}  // namespace ridgeline::reconstruct
