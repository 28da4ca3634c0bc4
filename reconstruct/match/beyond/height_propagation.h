// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/beyond/options.h"
#include "reconstruct/match/chio_wang2000/chio_match.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Matches of lines that another matcher has left unmatched and that meet matched ones, at the
/// height of these. They are what the third process of Chio and Wang 2000 finds beside the given
/// matches, by its close limit. A given match that is none of Core's candidates lends no height.
std::vector<Correspondence> propagate_heights(const StereoPair& pair,
                                              std::span<const Correspondence> given,
                                              const ChioOptions& chio,
                                              const CandidateOptions& candidates,
                                              const ChioExtensions& beyond,
                                              const MatchExtensionOptions& options);

}  // namespace ridgeline::reconstruct
