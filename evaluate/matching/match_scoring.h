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
  /// Each left segment with a segment of the other image that shows its edge.
  std::vector<Correspondence> missed;
};

/// Judges matches against true edges. A segment lies on an edge if the two run side by side over
/// half of the shorter one, within 2 px and 10 degrees. It certainly lies there if it is within
/// half of that distance, because shadows and gutters run along edges. It may lie on several edges
/// that are close together or that continue each other behind an occluding object. A match is
///   unjudged  if neither segment certainly lies on an edge (texture, shadows), or if one lies on
///             an edge and the other, which lies on none, continues that edge beyond its visible
///             part by at most its length;
///   correct   otherwise, if both segments lie on a common edge;
///   false     otherwise, and also if it is unjudged and its segments lie on the two edges of a
///             wrong pair.
/// A left segment without any match is missed if it certainly lies on an edge for which there is a
/// suitable right segment. This must certainly lie on the same edge, overlap the left segment along
/// the edge by at least half of the shorter one, and not be matched with another left segment
/// there. (The right image may show only one of two parallel lines.) A left segment with a false
/// match counts as false but not as missed. Throws std::invalid_argument for a match whose index is
/// out of range.
MatchingScore score_matches(std::span<const Segment2> left,
                            std::span<const Segment2> right,
                            std::span<const Correspondence> matches,
                            std::span<const ReferenceEdge> edges);

/// Judges matches against a list of true matches. A match is correct if it is in the list, unjudged
/// if neither of its segments is, and false otherwise. A left segment of the list is missed if it
/// is not in any match.
MatchingScore score_matches(std::span<const Correspondence> matches,
                            std::span<const Correspondence> reference);

}  // namespace ridgeline::evaluate
