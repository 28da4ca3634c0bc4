// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/chio_wang2000/combine_matches.h"

#include "reconstruct/ok2011/match/similarity_voting.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace ridgeline::reconstruct {

std::vector<CombinedMatch> combine_matches(std::span<const EdgeSegment> left,
                                           std::span<const ScoredMatch> pairwise,
                                           std::span<const ChioLine> chio) {
  constexpr int kLastProcess = 4;
  std::map<std::pair<int, int>, CombinedMatch> by_ids;
  std::set<int> matched;
  std::multimap<int, int> left_of_right;
  for (const ScoredMatch& scored : pairwise) {
    by_ids[{scored.match.left, scored.match.right}] = {scored, MatchSource::kPairwise};
    matched.insert(scored.match.left);
    left_of_right.emplace(scored.match.right, scored.match.left);
  }
  for (const ChioLine& line : chio) {
    const LineMatch& match = line.scored.match;
    const auto found = by_ids.find({match.left, match.right});
    if (found != by_ids.end()) found->second.source = MatchSource::kBoth;
    if (matched.contains(match.left)) continue;
    const auto [begin, end] = left_of_right.equal_range(match.right);
    const bool is_free = std::all_of(begin, end, [&](const auto& taken) {
      return are_fragments(left[match.left].line.segment, left[taken.second].line.segment);
    });
    if (is_free && line.acquired.process < kLastProcess) {
      by_ids[{match.left, match.right}] = {line.scored, MatchSource::kChio};
    }
  }
  std::vector<CombinedMatch> combined;
  combined.reserve(by_ids.size());
  for (const auto& [ids, match] : by_ids) combined.push_back(match);
  return combined;
}

}  // namespace ridgeline::reconstruct
