// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/matching_quality.h"
#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/field.h"
#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace ridgeline::evaluate {

enum class MatchVerdict : std::uint8_t { kUnjudged, kCorrect, kFalse };
const char* name(MatchVerdict verdict);  ///< unjudged | correct | false

struct MatchScoringOptions {
  double max_distance_px = 2.0;  ///< of a segment from the edge it lies on, at both ends
  double max_angle_deg = 10.0;   ///< between segment and edge: 2 px at both ends of the shortest
  double min_overlap = 0.5;      ///< share of the shorter of segment and edge beside the other

  static constexpr auto fields() {
    using O = MatchScoringOptions;
    return std::tuple{Field{"match_distance_px", &O::max_distance_px, 0.0, 100.0,
                            "largest distance of a segment from its reference edge"},
                      Field{"match_angle_deg", &O::max_angle_deg, 0.0, 90.0,
                            "largest angle between a segment and its reference edge"},
                      Field{"match_overlap", &O::min_overlap, 0.0, 1.0,
                            "of the shorter of segment and reference edge, beside the other"}};
  }
};

/// Table 1 of one patch (Ok et al. 2011, section 4).
struct MatchingScore {
  MatchCounts counts;
  std::size_t n_unjudged = 0;          ///< matches that the reference cannot judge
  std::vector<MatchVerdict> verdicts;  ///< of each match
  /// Each with a segment of the other image that shows its edge.
  std::vector<Correspondence> missed;
};

/// Judges matches by true edges. A segment lies on an edge if the two run side by side over
/// min_overlap of the shorter one, within max_distance_px and max_angle_deg. It certainly lies
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
/// std::invalid_argument for a match whose index is out of range and for options out of range.
MatchingScore score_matches(std::span<const Segment2> left,
                            std::span<const Segment2> right,
                            std::span<const Correspondence> matches,
                            std::span<const ReferenceEdge> edges,
                            const MatchScoringOptions& options = {});

/// Judges matches by a list of the true ones. A match is correct if the list has it, unjudged if
/// the list has neither of its segments, and else false. A left segment of the list is missed if it
/// is in no match.
MatchingScore score_matches(std::span<const Correspondence> matches,
                            std::span<const Correspondence> reference);

}  // namespace ridgeline::evaluate
