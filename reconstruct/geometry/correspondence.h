// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <string>
#include <utility>

namespace ridgeline {

/// A segment of the base view and one of another view that show the same line, by their indices.
struct Correspondence {
  int base = 0;
  int other = 0;
  double score = 0.0;  ///< similarity in [0, 1]
  double votes = 0.0;  ///< sum of the scores of the pairs that support it
  /// "pairwise", "pairwise_height" (by the height of neighbours), "chio", "guided" (by the
  /// surface), or the name of another tool; two names are joined by '+' if both found it. Empty
  /// within a matcher.
  std::string matcher{};

  /// Correspondences are ordered by these.
  [[nodiscard]] std::pair<int, int> segments() const { return {base, other}; }
};

/// An edge with the part of it that is visible in each of two images, in one direction of travel.
/// Pixels.
struct ReferenceEdge {
  Segment2 base, other;
  /// The two segments are known not to show one edge (judged false by eye). Such an entry makes a
  /// correspondence of the two false and says nothing else.
  bool is_wrong_pair = false;
  std::string id{}, kind{};
};

/// Two lines that form a pair in both images and may meet in object space, by the indices of their
/// correspondences or tracks.
struct PairConnection {
  int i = 0;
  int k = 0;
};

}  // namespace ridgeline
