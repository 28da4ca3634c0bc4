// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/reference_matches.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace ridgeline::simulate {
namespace {

double common_length(const PlanInterval& a, const PlanInterval& b) {
  return std::min(a.end, b.end) - std::max(a.begin, b.begin);
}

/// The pairs of runs with the longest common parts; each run is used at most once.
std::vector<std::pair<VisibleRun, VisibleRun>> paired(const std::vector<VisibleRun>& left,
                                                      const std::vector<VisibleRun>& right) {
  struct PossibleMatch {
    std::size_t i, k;
    double common_length;
  };
  std::vector<PossibleMatch> pairs;
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (std::size_t k = 0; k < right.size(); ++k) {
      const double both = common_length(left[i].run, right[k].run);
      if (both > 0.0) pairs.push_back({i, k, both});
    }
  }
  std::ranges::stable_sort(pairs, std::greater(), &PossibleMatch::common_length);
  std::vector<char> left_used(left.size(), 0);
  std::vector<char> right_used(right.size(), 0);
  std::vector<std::pair<VisibleRun, VisibleRun>> result;
  for (const PossibleMatch& pair : pairs) {
    if (left_used[pair.i] != 0 || right_used[pair.k] != 0) continue;
    left_used[pair.i] = right_used[pair.k] = 1;
    result.emplace_back(left[pair.i], right[pair.k]);
  }
  return result;
}

}  // namespace

std::vector<ReferenceEdge> reference_matches(std::span<const ShownEdge> edges) {
  std::vector<ShownEdge> candidates;
  for (const ShownEdge& edge : edges) {
    for (const auto& [left, right] : paired(edge.in_view(0), edge.in_view(1))) {
      if (!is_clear(left) || !is_clear(right)) continue;
      candidates.push_back({edge.kind, edge.rank, {left, right}});
    }
  }
  std::vector<ReferenceEdge> matches;
  for (const ShownEdge& edge : without_duplicates(std::move(candidates))) {
    matches.push_back({.base = edge.runs[0].segment_px,
                       .other = edge.runs[1].segment_px,
                       .id = std::to_string(matches.size()),
                       .kind = edge.kind});
  }
  return matches;
}

}  // namespace ridgeline::simulate
