// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/combine_matches.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace ridgeline::reconstruct {

std::vector<Correspondence> combine_matches(std::span<const EdgeSegment> left,
                                            std::vector<Correspondence> pairwise,
                                            std::span<const ChioLine> chio) {
  constexpr int kLastProcess = 4;
  constexpr const char* kChio = "chio";
  std::map<std::pair<int, int>, Correspondence> combined;  // by their segments
  std::set<int> matched;
  std::multimap<int, int> left_of_right;
  for (Correspondence& found : pairwise) {
    matched.insert(found.base);
    left_of_right.emplace(found.other, found.base);
    combined[found.segments()] = std::move(found);
  }
  for (const ChioLine& line : chio) {
    const Correspondence& match = line.match;
    const auto found = combined.find(match.segments());
    if (found != combined.end()) found->second.matcher += std::string("+") + kChio;
    if (matched.contains(match.base)) continue;
    const auto [begin, end] = left_of_right.equal_range(match.other);
    const bool is_free = std::all_of(begin, end, [&](const auto& taken) {
      return are_fragments(left[match.base].line.segment, left[taken.second].line.segment);
    });
    if (!is_free || line.acquired.process >= kLastProcess) continue;
    combined[match.segments()] = match;
    combined[match.segments()].matcher = kChio;
  }
  std::vector<Correspondence> list;
  list.reserve(combined.size());
  for (auto& [segments, found] : combined) list.push_back(std::move(found));
  return list;
}

}  // namespace ridgeline::reconstruct
