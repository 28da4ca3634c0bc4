// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/match/chio_wang2000/chio_match.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The matches of two matchers as one list, sorted by left, then by right index. It has all matches
/// of `pairwise`, and those lines of the first three processes of `chio` whose left segment
/// `pairwise` has left unmatched and whose right one it has given to no other left edge. The fourth
/// process is left out: that something nearby has its height is not enough for a line that
/// `pairwise` does not match. A match that both have found keeps the score and votes of `pairwise`;
/// "+chio" is added to its matcher.
std::vector<Correspondence> combine_matches(std::span<const EdgeSegment> left,
                                            std::vector<Correspondence> pairwise,
                                            std::span<const ChioLine> chio);

}  // namespace ridgeline::reconstruct
