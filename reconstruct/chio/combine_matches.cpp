// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/chio/combine_matches.h"

#include "reconstruct/match/similarity_voting.h"

#include <algorithm>
#include <map>

namespace ridgeline::reconstruct {

std::vector<CombinedMatch> combine_matches(std::span<const EdgeSegment> left,
                                           std::span<const ScoredMatch> pairwise,
                                           std::span<const ChioLine> chio) {
  constexpr int kLastProcess = 4;
  std::map<int, CombinedMatch> by_left;
  std::multimap<int, int> left_of_right;
  for (const ScoredMatch& scored : pairwise) {
    by_left[scored.match.left] = {scored, MatchSource::kPairwise};
    left_of_right.emplace(scored.match.right, scored.match.left);
  }
  for (const ChioLine& line : chio) {
    const LineMatch& match = line.scored.match;
    const auto found = by_left.find(match.left);
    if (found != by_left.end()) {
      if (found->second.scored.match.right == match.right)
        found->second.source = MatchSource::kBoth;
      continue;
    }
    const auto [begin, end] = left_of_right.equal_range(match.right);
    const bool is_free = std::all_of(begin, end, [&](const auto& taken) {
      return are_fragments(left[match.left].line.segment, left[taken.second].line.segment);
    });
    if (is_free && line.acquired.process < kLastProcess) {
      by_left[match.left] = {line.scored, MatchSource::kChio};
    }
  }
  std::vector<CombinedMatch> combined;
  combined.reserve(by_left.size());
  for (const auto& [id, match] : by_left) combined.push_back(match);
  return combined;
}

}  // namespace ridgeline::reconstruct
