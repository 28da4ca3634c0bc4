// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <string>

namespace ridgeline {

/// A segment of the left (base) image and its mate in the right one, by their indices.
struct LineMatch {
  int left = 0;
  int right = 0;
  friend auto operator<=>(const LineMatch&, const LineMatch&) = default;
};

/// A match with its similarity and its votes.
struct ScoredMatch {
  LineMatch match;
  double score = 0.0;  ///< similarity in [0, 1]
  double votes = 0.0;  ///< sum of the scores of the pairs that support it
};

/// A match and the name of the matcher that found it.
struct FoundMatch {
  ScoredMatch scored;
  /// "pairwise", "pairwise_height" (by the height of neighbours), "chio", "guided" (by the
  /// surface), or the name of another tool; two names are joined by '+' if both found the match.
  std::string matcher;
};

/// Two line matches, by their indices, that form a pair in both images and may meet in object
/// space.
struct PairConnection {
  int i = 0;
  int k = 0;
};

}  // namespace ridgeline
