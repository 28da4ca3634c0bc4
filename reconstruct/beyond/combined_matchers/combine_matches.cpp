// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/combined_matchers/combine_matches.h"

#include <algorithm>
#include <map>
#include <set>

namespace ridgeline::reconstruct {

std::vector<FoundMatch> combine_matches(std::span<const EdgeSegment> left,
                                        std::vector<FoundMatch> pairwise,
                                        std::span<const ChioLine> chio) {
  constexpr int kLastProcess = 4;
  constexpr const char* kChio = "chio";
  std::map<LineMatch, FoundMatch> combined;
  std::set<int> matched;
  std::multimap<int, int> left_of_right;
  for (FoundMatch& found : pairwise) {
    const LineMatch match = found.scored.match;
    combined[match] = std::move(found);
    matched.insert(match.left);
    left_of_right.emplace(match.right, match.left);
  }
  for (const ChioLine& line : chio) {
    const LineMatch& match = line.scored.match;
    const auto found = combined.find(match);
    if (found != combined.end()) found->second.matcher += std::string("+") + kChio;
    if (matched.contains(match.left)) continue;
    const auto [begin, end] = left_of_right.equal_range(match.right);
    const bool is_free = std::all_of(begin, end, [&](const auto& taken) {
      return are_fragments(left[match.left].line.segment, left[taken.second].line.segment);
    });
    if (is_free && line.acquired.process < kLastProcess) combined[match] = {line.scored, kChio};
  }
  std::vector<FoundMatch> list;
  list.reserve(combined.size());
  for (auto& [match, found] : combined) list.push_back(std::move(found));
  return list;
}

}  // namespace ridgeline::reconstruct
