// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/matching_quality.h"
#include "reconstruct/geometry/field.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace ridgeline::evaluate {

/// A true edge: the part of it that is visible in each image, in one direction of travel. Pixels.
struct EdgeInBoth {
  Segment2 left, right;
  /// True: `left` and `right` are known not to show one edge (a match judged false by eye). Such an
  /// entry makes a match of the two false and says nothing else.
  bool is_wrong_pair = false;
};

enum class MatchVerdict : std::uint8_t { kUnjudged, kCorrect, kFalse };
const char* name(MatchVerdict verdict);  ///< unjudged | correct | false

struct MatchScoringOptions {
  double max_distance_px = 2.0;  ///< of a segment from the edge it lies on, at both ends
  double max_angle_deg = 10.0;   ///< between them: 2 px at both ends of the shortest segments
  double min_overlap = 0.5;      ///< of the shorter of segment and edge, beside the other

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
  std::size_t n_unjudged = 0;          ///< matches of which the reference knows neither segment
  std::vector<MatchVerdict> verdicts;  ///< of each match
  std::vector<LineMatch> missed;       ///< with a right segment that would have been a mate
};

/// Judges matches by true edges. A segment lies on an edge if the two run side by side over
/// min_overlap of the shorter one, within max_distance_px and max_angle_deg; certainly so within
/// half of that distance, since shadows and gutters run along edges. It may lie on several edges
/// that are close together, or that continue each other behind something in front of them.
///   unjudged  neither segment certainly lies on an edge (texture, shadows), or one lies on an edge
///             and the other, on none, continues it beyond its visible part by at most its length
///   correct   else, if both segments lie on a common edge
///   false     else; and if the two segments lie on the two of a wrong pair, but on no common edge
///   missed    left segments without any match that certainly lie on an edge on which a right
///             segment certainly lies too, at least half of the shorter one beside the other along
///             the edge, unless it is the mate of another left segment beside this one: of two
///             parallel lines close together the right image may show one only
/// A left segment with a false match is false, not missed as well. Throws std::invalid_argument for
/// a match whose index is out of range and for options out of range.
MatchingScore score_matches(std::span<const Segment2> left,
                            std::span<const Segment2> right,
                            std::span<const LineMatch> matches,
                            std::span<const EdgeInBoth> edges,
                            const MatchScoringOptions& options = {});

/// Judges matches by a list of the true ones. Correct: in the list; false: not, but one of its
/// segments is; unjudged: neither is; missed: left segments of the list without any match.
MatchingScore score_matches(std::span<const LineMatch> matches,
                            std::span<const LineMatch> reference);

}  // namespace ridgeline::evaluate
