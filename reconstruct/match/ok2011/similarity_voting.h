// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/ok2011/pair_similarity.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The segments of two views and the candidates of the left segments.
struct MatchChoices {
  const View& left;
  const View& right;
  const Candidates& candidates;

  [[nodiscard]] const Segment2& left_line(std::size_t i) const {
    return left.segments[i].line.segment;
  }
  [[nodiscard]] const Segment2& counterpart(const Candidate& candidate) const {
    return right.segments[candidate.right].line.segment;
  }
  [[nodiscard]] OverlappedSegment on_left(std::size_t i, const Candidate& candidate) const {
    return {left_line(i), candidate.overlap};
  }
  [[nodiscard]] OverlappedSegment on_right(const Candidate& candidate) const {
    return {counterpart(candidate), candidate.overlap};
  }
};

/// The evidence for a candidate besides its own appearance.
struct Support {
  /// Sum of the votes of its partners. For each partner the best pair counts: the vote of the pair
  /// times the probability of the other member.
  double votes = 0.0;
  double vote_share = 0.0;  ///< votes as a share of the most that its partners could give; 0..1
  /// Share of the left segment's neighbours that are at the same height where the two come closest;
  /// 0..1. Nearer neighbours carry more weight.
  double height = 0.0;
  int n_pairs = 0;           ///< partners that support it
  double probability = 0.0;  ///< of being the counterpart, relative to its rivals
};

/// The support of every candidate, in the order of the candidates.
using Supports = std::vector<std::vector<Support>>;

/// The iterated vote. Each pair match votes for both of its line matches. Its vote is vote_of() the
/// pair's similarity, times the probability that the other member is correct. For each partner the
/// best pair counts. A candidate's strength is a logistic regression over its own appearance, its
/// votes and the agreement of its height with its neighbours. Its probability is its strength
/// relative to that of its rivals. Rivals are other counterparts for the left segment, unless both
/// counterparts are fragments of one edge, and other left segments for the counterpart, unless
/// these may share it. The regression was fitted to the simulated training scenes (seeds 1 to 8)
/// and then tuned for the best matching quality in them. The vote is repeated until it reaches a
/// fixed point, in at most 20 passes. The result is the same for any number of threads.
/// @param transfer  from the left image to the right one, at any place; it gives the ground size of
///                  a pixel and the height that corresponds to one pixel of parallax
Supports similarity_votes(const MatchChoices& choices,
                          std::span<const PairMatch> pairs,
                          const LocalTransfer& transfer);

}  // namespace ridgeline::reconstruct
