// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/matching_quality.h"
#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

enum class MatchVerdict : std::uint8_t { kUnjudged, kCorrect, kFalse };
const char* name(MatchVerdict verdict);  ///< unjudged | correct | false

/// Table 1 of one patch (Ok et al. 2011, section 4).
struct MatchingScore {
  MatchCounts counts;
  std::size_t n_unjudged = 0;          ///< matches that the reference cannot judge
  std::vector<MatchVerdict> verdicts;  ///< of each match
  /// Each with a segment of the other image that shows its edge.
  std::vector<Correspondence> missed;
};

/// Judges matches by true edges. A segment lies on an edge if the two run side by side over
/// half of the shorter one, within 2 px and 10 degrees. It certainly lies
/// there within half of that distance, since shadows and gutters run along edges. It may lie on
/// several edges that are close together, or that continue each other behind something in front of
/// them.
///   unjudged  Neither segment certainly lies on an edge (texture, shadows), or one lies on an edge
///             and the other one, which lies on none, continues that edge beyond its visible part
///             by at most its length.
///   correct   Otherwise, if both segments lie on a common edge.
///   false     Otherwise, and an unjudged match whose segments lie on the two edges of a wrong
///   pair. missed    A left segment without any match that certainly lies on an edge for which
///   there is a
///             right segment: one that certainly lies on that edge too, at least half of the
///             shorter one beside the other along the edge, and that is not matched with another
///             left segment beside this one. (The right image may show only one of two parallel
///             lines.)
/// A left segment with a false match counts as false, and not as missed too. Throws
/// std::invalid_argument for a match whose index is out of range.
MatchingScore score_matches(std::span<const Segment2> left,
                            std::span<const Segment2> right,
                            std::span<const Correspondence> matches,
                            std::span<const ReferenceEdge> edges);

/// Judges matches by a list of the true ones. A match is correct if the list has it, unjudged if
/// the list has neither of its segments, and else false. A left segment of the list is missed if it
/// is in no match.
MatchingScore score_matches(std::span<const Correspondence> matches,
                            std::span<const Correspondence> reference);

}  // namespace ridgeline::evaluate
