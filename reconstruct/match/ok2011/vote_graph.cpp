// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/vote_graph.h"

#include "reconstruct/geometry/box_index.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// The closest points of two segments as parameters of each.
NearSegment closest(const Segment2& own, int other, const Segment2& segment) {
  if (const auto x = intersection(own, segment, 0.0)) {
    const double own_t = closest_parameter(own, *x);
    const double t = closest_parameter(segment, *x);
    if (own_t > 0.0 && own_t < 1.0 && t > 0.0 && t < 1.0) return {other, 0.0, own_t, t};
  }
  NearSegment best{other, std::numeric_limits<double>::infinity(), 0.0, 0.0};
  const auto offer = [&](double own_t, double t) {
    const double apart_px = (point_at(own, own_t) - point_at(segment, t)).norm();
    if (apart_px < best.distance_px) best = {other, apart_px, own_t, t};
  };
  for (const double end : {0.0, 1.0}) {
    offer(end, closest_parameter(segment, point_at(own, end)));
    offer(closest_parameter(own, point_at(segment, end)), end);
  }
  return best;
}

/// Adds the rivals with the same left segment: its other counterparts.
void add_row_rivals(VoteGraph& graph, const MatchChoices& choices) {
  for (std::size_t i = 0; i + 1 < graph.first.size(); ++i) {
    for (Flat a = graph.first[i]; a < graph.first[i + 1]; ++a) {
      for (Flat b = graph.first[i]; b < graph.first[i + 1]; ++b) {
        if (a == b) continue;
        if (!are_fragments(choices.counterpart(*graph.candidates[a]),
                           choices.counterpart(*graph.candidates[b]))) {
          graph.rivals[a].push_back(b);
        }
      }
    }
  }
}

/// Adds the rivals with the same counterpart: other left segments to which it may belong.
void add_column_rivals(VoteGraph& graph, const MatchChoices& choices) {
  const auto part = [&](Flat c) { return choices.on_left(graph.left[c], *graph.candidates[c]); };
  std::vector<std::vector<Flat>> of_right(choices.right.segments.size());
  for (Flat c = 0; c < static_cast<Flat>(graph.candidates.size()); ++c) {
    of_right[graph.candidates[c]->right].push_back(c);
  }
  for (const std::vector<Flat>& column : of_right) {
    for (const Flat a : column) {
      for (const Flat b : column) {
        if (a != b && !may_share_counterpart(part(a), part(b))) graph.rivals[a].push_back(b);
      }
    }
  }
}

void add_links(VoteGraph& graph, std::span<const PairMatch> pairs) {
  for (const PairMatch& match : pairs) {
    const Flat a = graph.first[match.pair.first] + match.first_candidate;
    const Flat b = graph.first[match.pair.second] + match.second_candidate;
    const double vote = vote_of(match.similarity);
    graph.links[a].push_back({match.pair.second, b, vote});
    graph.links[b].push_back({match.pair.first, a, vote});
  }
  for (std::vector<Link>& links : graph.links) {
    std::ranges::sort(links, {}, [](const Link& l) { return std::pair(l.partner, l.candidate); });
  }
}

std::vector<NearSegment> neighbours_of(std::size_t segment,
                                       std::span<const Segment2> segments,
                                       const BoxIndex2& index) {
  constexpr double kReach_px = 60.0;
  constexpr std::size_t kMaxNeighbours = 12;
  const Segment2& own = segments[segment];
  std::vector<NearSegment> neighbours;
  for (const std::size_t other : index.near(own, kReach_px)) {
    if (other == segment) continue;
    const NearSegment neighbour = closest(own, static_cast<int>(other), segments[other]);
    if (neighbour.distance_px <= kReach_px) neighbours.push_back(neighbour);
  }
  std::ranges::stable_sort(neighbours, {}, &NearSegment::distance_px);
  if (neighbours.size() > kMaxNeighbours) neighbours.resize(kMaxNeighbours);
  return neighbours;
}

void add_neighbours(VoteGraph& graph, const View& left) {
  const std::vector<Segment2> segments = ideal_segments(left);
  const BoxIndex2 index(segments);
  graph.neighbours.resize(segments.size());
  tbb::parallel_for(std::size_t{0}, segments.size(), [&](std::size_t i) {
    graph.neighbours[i] = neighbours_of(i, segments, index);
  });
}

}  // namespace

VoteGraph vote_graph(const MatchChoices& choices,
                     std::span<const PairMatch> pairs,
                     const LocalTransfer& transfer) {
  constexpr double kGutters_m = 0.6;  // gutters and the like lie between edges that meet
  constexpr double kNoise_px = 2.0;   // noise of the parallax
  VoteGraph graph;
  graph.gsd_m = transfer.gsd_m;
  graph.same_height_m = std::max(kGutters_m, kNoise_px / transfer.per_height.norm());
  graph.first.push_back(0);
  for (std::size_t i = 0; i < choices.candidates.size(); ++i) {
    for (const Candidate& candidate : choices.candidates[i]) {
      graph.candidates.push_back(&candidate);
      graph.left.push_back(static_cast<int>(i));
    }
    graph.first.push_back(static_cast<int>(graph.candidates.size()));
  }
  graph.rivals.resize(graph.candidates.size());
  graph.links.resize(graph.candidates.size());
  add_row_rivals(graph, choices);
  add_column_rivals(graph, choices);
  add_links(graph, pairs);
  add_neighbours(graph, choices.left);
  return graph;
}

}  // namespace ridgeline::reconstruct
