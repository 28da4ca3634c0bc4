// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/chio/combine_matches.h"

#include "reconstruct/match/similarity_voting.h"

#include <algorithm>
#include <map>

namespace ridgeline::reconstruct {

std::vector<CombinedMatch> combine_matches(std::span<const EdgeSegment> left,
                                           std::span<const ScoredMatch> first,
                                           std::span<const ScoredMatch> second) {
  std::map<int, CombinedMatch> by_left;
  std::multimap<int, int> left_of_right;
  for (const ScoredMatch& scored : first) {
    by_left[scored.match.left] = {scored, MatchSource::kFirst};
    left_of_right.emplace(scored.match.right, scored.match.left);
  }
  for (const ScoredMatch& scored : second) {
    const auto found = by_left.find(scored.match.left);
    if (found != by_left.end()) {
      if (found->second.scored.match.right == scored.match.right) {
        found->second.source = MatchSource::kBoth;
      }
      continue;
    }
    const auto [begin, end] = left_of_right.equal_range(scored.match.right);
    const bool is_free = std::all_of(begin, end, [&](const auto& taken) {
      return are_fragments(left[scored.match.left].line.segment, left[taken.second].line.segment);
    });
    if (is_free) by_left[scored.match.left] = {scored, MatchSource::kSecond};
  }
  std::vector<CombinedMatch> combined;
  combined.reserve(by_left.size());
  for (const auto& [id, match] : by_left) combined.push_back(match);
  return combined;
}

}  // namespace ridgeline::reconstruct
