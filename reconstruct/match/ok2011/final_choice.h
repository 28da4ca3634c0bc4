// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/ok2011/base_pairs.h"
#include "reconstruct/match/ok2011/match_pairwise.h"
#include "reconstruct/match/ok2011/similarity_voting.h"

#include <span>

namespace ridgeline::reconstruct {

/// The last step of the matching. Left segments take their most probable counterpart, in order of
/// probability. The counterpart must reach min_probability, the next counterpart must stay
/// below 0.8 of that, and no other edge may have taken the counterpart. (Other left segments that
/// want the counterpart are rivals in the probability already. The same ratio for them as well was
/// tried; it lost more right matches than wrong ones.) A counterpart may serve several fragments of
/// one left edge, and a left segment may have several fragments of one right edge as counterparts,
/// each with a part of its own. A further counterpart needs a probability of 0.7. A match needs 0.9
/// if one of its segments is shorter than 12 px, and 0.6 if one segment is shorter than three
/// quarters of the other. A line whose partners in the base pairs are matched needs min_votes from
/// its pairs. An isolated line is chosen by its appearance alone.
MatchResult final_choice(const MatchChoices& choices,
                         const Supports& supports,
                         std::span<const BasePair> pairs,
                         const MatchOptions& options);

}  // namespace ridgeline::reconstruct
