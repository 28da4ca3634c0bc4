// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/ok2011/base_pairs.h"
#include "reconstruct/match/ok2011/match_pairwise.h"
#include "reconstruct/match/ok2011/similarity_voting.h"

#include <span>

namespace ridgeline::reconstruct {

/// The last step of the matching. Left segments take their most probable counterpart, in order of
/// probability. The counterpart must reach min_probability, the second best must not exceed 0.8 of
/// its probability, and no other edge may have taken the counterpart. (The probability already
/// accounts for other left segments that compete for the counterpart. Applying the same ratio to
/// them as well lost more correct matches than wrong ones.) A counterpart may serve several
/// fragments of one left edge, and a left segment may have several fragments of one right edge as
/// counterparts, each covering a part of its own. A further counterpart needs a probability of 0.7.
/// A match needs 0.9 if one of its segments is shorter than 12 px, and 0.6 if one segment is
/// shorter than three quarters of the other. A line whose partners in the base pairs are matched
/// needs min_votes from its pairs. An isolated line is chosen by its appearance alone.
MatchResult final_choice(const MatchChoices& choices,
                         const Supports& supports,
                         std::span<const BasePair> pairs,
                         const MatchOptions& options);

}  // namespace ridgeline::reconstruct
