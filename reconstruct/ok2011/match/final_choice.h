// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/match/base_pairs.h"
#include "reconstruct/ok2011/match/match_pairwise.h"
#include "reconstruct/ok2011/match/similarity_voting.h"

#include <span>

namespace ridgeline::reconstruct {

/// The last step of the matching: left segments take their most probable mate, in order of
/// probability, if it reaches min_probability, its next mate does not come closer than
/// max_distance_ratio and no other edge has taken it. (Other left segments that want the mate are
/// rivals in the probability already; the same ratio for them as well, tried, lost more right matches
/// than wrong ones.) A mate may serve several fragments of one left
/// edge, and a left segment may have several fragments of one right edge as mates, each with a part of
/// its own; a further mate from a probability of 0.7 on. The
/// shortest segments, below 12 px, take one from 0.9 on, those below three quarters of their mate's length
/// from 0.6 on. A line whose partners in the base pairs are
/// matched needs min_votes of them; an isolated one its look alone.
MatchResult final_choice(const MatchChoices& choices,
                         const Supports& supports,
                         std::span<const BasePair> pairs,
                         const MatchOptions& options);

}  // namespace ridgeline::reconstruct
