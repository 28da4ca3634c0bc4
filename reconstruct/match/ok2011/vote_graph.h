// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/ok2011/similarity_voting.h"

#include <span>
#include <vector>

// The graph that similarity_votes() iterates over: who votes for whom, and who competes with whom.

namespace ridgeline::reconstruct {

/// Index of a candidate in the flat list of all candidates.
using Flat = int;

/// A pair match seen from one of its members.
struct Link {
  int partner;     ///< the left segment of the other member
  Flat candidate;  ///< the candidate of the other member
  double vote;
};

/// A nearby segment whose height should agree where the two segments come closest.
struct NearSegment {
  int segment;
  double distance_px;
  double own_t, t;  ///< parameters of the closest points: on the segment itself, on the neighbour
};

/// The candidates of all left segments and the links between them.
struct VoteGraph {
  /// By left segment: index of its first candidate; the last entry is the number of candidates.
  std::vector<int> first;
  std::vector<const Candidate*> candidates;
  std::vector<int> left;                             ///< by candidate: its left segment
  std::vector<std::vector<Flat>> rivals;             ///< by candidate
  std::vector<std::vector<Link>> links;              ///< by candidate, ordered by partner
  std::vector<std::vector<NearSegment>> neighbours;  ///< by left segment
  double gsd_m = 0.0;
  double same_height_m = 0.0;  ///< expected height difference of lines that meet in the image
};

/// Rivals of a candidate are other counterparts of its left segment, unless both are fragments of
/// one edge, and the same counterpart for other left segments, unless these may share it.
/// @param transfer  see similarity_votes()
VoteGraph vote_graph(const MatchChoices& choices,
                     std::span<const PairMatch> pairs,
                     const LocalTransfer& transfer);

}  // namespace ridgeline::reconstruct
