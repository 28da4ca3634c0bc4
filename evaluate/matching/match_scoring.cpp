// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/matching/match_scoring.h"

#include "evaluate/matching/on_edge.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>

namespace ridgeline::evaluate {
namespace {

/// Whether a segment continues, in the image `own`, an edge on which the other segment lies.
bool continues_edge_of_other(const Segment2& segment,
                             const std::vector<Beside>& of_other,
                             std::span<const ReferenceEdge> edges,
                             Segment2 ReferenceEdge::*own) {
  return std::any_of(of_other.begin(), of_other.end(), [&](const Beside& beside) {
    return continues(segment, edges[beside.edge].*own);
  });
}

/// The edges on which each segment lies, in ascending order.
std::vector<std::vector<Beside>> edges_of(std::span<const Segment2> segments,
                                          std::span<const ReferenceEdge> edges,
                                          Segment2 ReferenceEdge::*image) {
  std::vector<std::vector<Beside>> found(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      auto beside = lies_on(segments[s], edges[e].*image);
      if (!beside) continue;
      beside->edge = static_cast<int>(e);
      found[s].push_back(*beside);
    }
  }
  return found;
}

bool any_certain(const std::vector<Beside>& besides) {
  return std::any_of(besides.begin(), besides.end(),
                     [&](const Beside& beside) { return is_certain(beside); });
}

bool have_common_edge(const std::vector<Beside>& a, const std::vector<Beside>& b) {
  return std::any_of(a.begin(), a.end(), [&](const Beside& x) {
    return std::any_of(b.begin(), b.end(), [&](const Beside& y) { return x.edge == y.edge; });
  });
}

bool overlap_along(const Beside& a, const Beside& b) {
  constexpr double kShare = 0.5;  // of the shorter stretch
  const double common = std::min(a.to, b.to) - std::max(a.from, b.from);
  return common > 0.0 && common >= kShare * std::min(a.to - a.from, b.to - b.from);
}

/// A segment that lies on an edge.
struct OnEdge {
  int segment = 0;
  Beside beside;
};

std::vector<std::vector<OnEdge>> segments_of_edges(const std::vector<std::vector<Beside>>& edges_of,
                                                   std::size_t n_edges) {
  std::vector<std::vector<OnEdge>> segments(n_edges);
  for (std::size_t s = 0; s < edges_of.size(); ++s) {
    for (const Beside& beside : edges_of[s]) {
      segments[beside.edge].push_back({static_cast<int>(s), beside});
    }
  }
  return segments;
}

/// For each right segment, the parts of edges on which its matched left segments lie.
using Taken = std::map<int, std::vector<Beside>>;

Taken taken_segments(std::span<const Correspondence> matches,
                     const std::vector<std::vector<Beside>>& on_left) {
  Taken taken;
  for (const Correspondence& match : matches) {
    for (const Beside& beside : on_left[match.base]) taken[match.other].push_back(beside);
  }
  return taken;
}

/// Whether no match uses this right segment for the same part of the edge.
bool is_free(const Taken& taken, int right, const Beside& wanted) {
  const auto it = taken.find(right);
  if (it == taken.end()) return true;
  return std::none_of(it->second.begin(), it->second.end(), [&](const Beside& other) {
    return other.edge == wanted.edge && overlap_along(other, wanted);
  });
}

/// The edges on which the segments of both images lie.
struct OnEdges {
  OnEdges(std::span<const Segment2> left_segments,
          std::span<const Segment2> right_segments,
          std::span<const ReferenceEdge> edges)
      : left(edges_of(left_segments, edges, &ReferenceEdge::base)),
        right(edges_of(right_segments, edges, &ReferenceEdge::other)) {}

  std::vector<std::vector<Beside>> left, right;
};

std::vector<ReferenceEdge> entries_of(std::span<const ReferenceEdge> reference, bool wrong_pairs) {
  std::vector<ReferenceEdge> entries;
  std::copy_if(reference.begin(), reference.end(), std::back_inserter(entries),
               [&](const ReferenceEdge& entry) { return entry.is_wrong_pair == wrong_pairs; });
  return entries;
}

MatchVerdict verdict_of(const Correspondence& match,
                        std::span<const Segment2> left,
                        std::span<const Segment2> right,
                        const OnEdges& on_edges,
                        std::span<const ReferenceEdge> edges) {
  const auto& a = on_edges.left[match.base];
  const auto& b = on_edges.right[match.other];
  const bool continued =
      (a.empty() && continues_edge_of_other(left[match.base], b, edges, &ReferenceEdge::base)) ||
      (b.empty() && continues_edge_of_other(right[match.other], a, edges, &ReferenceEdge::other));
  if (continued || (!any_certain(a) && !any_certain(b))) {
    return MatchVerdict::kUnjudged;
  }
  return have_common_edge(a, b) ? MatchVerdict::kCorrect : MatchVerdict::kFalse;
}

void add(MatchVerdict verdict, MatchingScore& score) {
  score.verdicts.push_back(verdict);
  if (verdict == MatchVerdict::kUnjudged) ++score.n_unjudged;
  if (verdict == MatchVerdict::kCorrect) ++score.counts.n_correct;
  if (verdict == MatchVerdict::kFalse) ++score.counts.n_false;
}

/// The unmatched left segments for which there is a free right segment on the same edge, each with
/// that segment.
std::vector<Correspondence> missed_matches(std::span<const Correspondence> matches,
                                           const OnEdges& on_edges,
                                           std::size_t n_edges) {
  const Taken taken = taken_segments(matches, on_edges.left);
  const auto of_edge = segments_of_edges(on_edges.right, n_edges);
  const auto free_segment = [&](const Beside& a) -> std::optional<int> {
    if (!is_certain(a)) return std::nullopt;
    for (const OnEdge& other : of_edge[a.edge]) {
      if (is_certain(other.beside) && overlap_along(a, other.beside) &&
          is_free(taken, other.segment, a)) {
        return other.segment;
      }
    }
    return std::nullopt;
  };
  std::vector<char> is_matched(on_edges.left.size(), 0);
  for (const Correspondence& match : matches) is_matched[match.base] = 1;
  std::vector<Correspondence> missed;
  for (std::size_t i = 0; i < on_edges.left.size(); ++i) {
    if (is_matched[i] != 0) continue;
    for (const Beside& beside : on_edges.left[i]) {
      const std::optional<int> other = free_segment(beside);
      if (!other) continue;
      missed.push_back({static_cast<int>(i), *other});
      break;
    }
  }
  return missed;
}

void check_indices(std::span<const Correspondence> matches,
                   std::size_t n_left,
                   std::size_t n_right) {
  for (const Correspondence& match : matches) {
    check(match.base >= 0 && static_cast<std::size_t>(match.base) < n_left,
          "left_id = ", match.base, ", must be below ", n_left);
    check(match.other >= 0 && static_cast<std::size_t>(match.other) < n_right,
          "right_id = ", match.other, ", must be below ", n_right);
  }
}

}  // namespace

const char* name(MatchVerdict verdict) {
  switch (verdict) {
    case MatchVerdict::kUnjudged:
      return "unjudged";
    case MatchVerdict::kCorrect:
      return "correct";
    case MatchVerdict::kFalse:
      return "false";
  }
  return "";
}

MatchingScore score_matches(std::span<const Segment2> left,
                            std::span<const Segment2> right,
                            std::span<const Correspondence> matches,
                            std::span<const ReferenceEdge> reference) {
  check_indices(matches, left.size(), right.size());
  const std::vector<ReferenceEdge> edges = entries_of(reference, false);
  const std::vector<ReferenceEdge> wrong_pairs = entries_of(reference, true);
  const OnEdges on_edges(left, right, edges);
  const OnEdges on_wrong_pairs(left, right, wrong_pairs);
  MatchingScore score;
  for (const Correspondence& match : matches) {
    MatchVerdict verdict = verdict_of(match, left, right, on_edges, edges);
    if (verdict == MatchVerdict::kUnjudged &&
        have_common_edge(on_wrong_pairs.left[match.base], on_wrong_pairs.right[match.other])) {
      verdict = MatchVerdict::kFalse;
    }
    add(verdict, score);
  }
  score.missed = missed_matches(matches, on_edges, edges.size());
  score.counts.n_missed = score.missed.size();
  return score;
}

MatchingScore score_matches(std::span<const Correspondence> matches,
                            std::span<const Correspondence> reference) {
  std::set<std::pair<int, int>> pairs;
  std::set<int> lefts;
  std::set<int> rights;
  for (const Correspondence& match : reference) {
    pairs.insert({match.base, match.other});
    lefts.insert(match.base);
    rights.insert(match.other);
  }
  MatchingScore score;
  std::set<int> matched;
  for (const Correspondence& match : matches) {
    matched.insert(match.base);
    if (pairs.contains({match.base, match.other})) {
      add(MatchVerdict::kCorrect, score);
    } else if (lefts.contains(match.base) || rights.contains(match.other)) {
      add(MatchVerdict::kFalse, score);
    } else {
      add(MatchVerdict::kUnjudged, score);
    }
  }
  for (const Correspondence& match : reference) {
    if (matched.insert(match.base).second) score.missed.push_back(match);
  }
  score.counts.n_missed = score.missed.size();
  return score;
}

}  // namespace ridgeline::evaluate
