// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/match/pair_similarity.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The segments of two views with the candidates of the left ones.
struct MatchChoices {
  const View& left;
  const View& right;
  const Candidates& candidates;

  [[nodiscard]] const Segment2& left_line(std::size_t i) const {
    return left.segments[i].line.segment;
  }
  [[nodiscard]] const Segment2& mate(const Candidate& candidate) const {
    return right.segments[candidate.right].line.segment;
  }
  [[nodiscard]] OverlappedSegment on_left(std::size_t i, const Candidate& candidate) const {
    return {left_line(i), candidate.overlap};
  }
  [[nodiscard]] OverlappedSegment on_right(const Candidate& candidate) const {
    return {mate(candidate), candidate.overlap};
  }
};

/// What speaks for a candidate besides its own look.
struct Support {
  double votes = 0.0;  ///< similarities of the pairs that contain it, by the trust in the partner
  double vote_share = 0.0;  ///< votes over those its partners could have given; 0..1
  double height =
      0.0;  ///< share of its neighbours, by nearness, at its height where they are closest; 0..1
  int n_pairs = 0;           ///< partners that support it
  double probability = 0.0;  ///< that it is the mate, against its rivals
};

/// The support of every candidate, in the order of the candidates.
using Supports = std::vector<std::vector<Support>>;

/// The iterated vote. Each pair match votes for both of its line matches with its similarity, times
/// the probability that its other member is right; for each partner the best pair counts. A
/// candidate's strength is a logistic regression over its own look, its votes and the agreement of
/// its height with its neighbours; its probability is its strength against that of its rivals: other
/// mates for the left segment, other left segments for its mate. Collinear fragments of one edge are
/// no rivals, nor are mates that lie on one line side by side, of which one is taken. The regression was
/// fitted to the simulated training scenes (seeds 1 to 8) and then adjusted for the best quality of
/// matching in them. Repeated to a fixed point, at most 20 passes. The same for any number of threads.
/// @param transfer  of the left image to the right one, anywhere in it: what a pixel is on the ground
///                  and a pixel of parallax in height
Supports similarity_votes(const MatchChoices& choices,
                          std::span<const PairMatch> pairs,
                          const LocalTransfer& transfer);

}  // namespace ridgeline::reconstruct
