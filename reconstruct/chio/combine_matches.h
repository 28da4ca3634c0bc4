// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/line_match.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Which of two matchers found a match.
enum class MatchSource : std::uint8_t { kFirst, kSecond, kBoth };

struct CombinedMatch {
  ScoredMatch scored;  ///< as the first matcher has it, if it does
  MatchSource source = MatchSource::kFirst;
};

/// The matches of two matchers as one list, by left index: all of the first, and those of the second
/// whose left segment the first has left unmatched and whose right one it has given to no other left
/// edge. Each list at most one match per left segment.
std::vector<CombinedMatch> combine_matches(std::span<const EdgeSegment> left,
                                           std::span<const ScoredMatch> first,
                                           std::span<const ScoredMatch> second);

}  // namespace ridgeline::reconstruct
