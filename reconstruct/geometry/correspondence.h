// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <string>
#include <utility>

namespace ridgeline {

/// The indices of a segment of the base view and a segment of another view that show the same line.
struct Correspondence {
  int base = 0;
  int other = 0;
  double score = 0.0;  ///< similarity in [0, 1]
  double votes = 0.0;  ///< sum of the scores of the pairs that support this correspondence
  /// "pairwise", "pairwise_height" (from the heights of neighbours), "chio", "guided" (from the
  /// surface), or the name of another tool; if two of them found the correspondence, their names
  /// are joined by '+'. Empty within a matcher.
  std::string matcher{};

  /// The sort key of correspondences.
  [[nodiscard]] std::pair<int, int> segments() const { return {base, other}; }
};

/// The visible part of an edge in each of two images, in pixels; both segments run in the same
/// direction along the edge.
struct ReferenceEdge {
  Segment2 base, other;
  /// The two segments are known to show different edges (judged by eye). Such an entry makes a
  /// correspondence of the two false and has no other effect.
  bool is_wrong_pair = false;
  std::string id{}, kind{};
};

/// The indices of the correspondences or tracks of two lines that form a pair in both images and
/// may meet in object space.
struct PairConnection {
  int i = 0;
  int k = 0;
};

}  // namespace ridgeline
