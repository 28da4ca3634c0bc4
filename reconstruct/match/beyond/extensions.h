// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/beyond/options.h"
#include "reconstruct/match/chio_wang2000/extensions.h"
#include "reconstruct/match/ok2011/match_pairwise.h"
#include "reconstruct/surface/surface.h"

namespace ridgeline::reconstruct {

/// The extensions of the matching that the options switch on: matched_radiometry, hidden_walls and
/// the depth of the surfaces beside a line (weigh_by_surface()).
/// @param candidates  options of the first search, which yields the radiometry
/// @param surface     the surface of the pair, or null; must live as long as the result
MatchExtensions match_extensions(const MatchExtensionOptions& options,
                                 const CandidateOptions& candidates,
                                 const Surface* surface = nullptr);

/// The extensions of the matching in object space that the options switch on.
/// @param change_appearance  changes the appearance of the candidates
ChioExtensions chio_extensions(const ChioExtensionOptions& options,
                               const CandidateAppearance& change_appearance);

}  // namespace ridgeline::reconstruct
