// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/match/match_extensions.h"

namespace ridgeline::reconstruct {

/// What goes beyond the paper in the matching, as the options switch it on: matched_radiometry, hidden_walls,
/// close_edges (the order of close lines).
MatchExtensions match_extensions(const MatchOptions& options);

}  // namespace ridgeline::reconstruct
