// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/match/similarity_voting.h"

#include "reconstruct/geometry/interruption.h"
#include "reconstruct/geometry/segment_index.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

constexpr int kMostPasses = 20;
constexpr double kFixedPoint = 1e-4;  // largest change of a probability
/// A share of support starts from "undecided" with this weight: a lone neighbour proves little, and
/// a segment without neighbours is judged by its look.
constexpr double kLittle = 0.5;
constexpr double kUndecided = 0.5;

/// A candidate by its place in the flat list of all.
using Flat = int;

/// A pair match seen from one of its members.
struct Link {
  int partner;     ///< left segment
  Flat candidate;  ///< of the partner
  double vote;
};

/// A segment nearby whose height should agree where the two come closest.
struct NearSegment {
  int segment;
  double distance_px;
  double own_t, t;  ///< of the closest points: on the segment itself, on the neighbour
};

struct VoteGraph {
  std::vector<int> first;  ///< per left segment: its first flat candidate; one more at the end
  std::vector<const Candidate*> candidates;
  std::vector<int> left;                             ///< left segment, per candidate
  std::vector<std::vector<Flat>> rivals;             ///< per candidate
  std::vector<std::vector<Link>> links;              ///< per candidate, by partner
  std::vector<std::vector<NearSegment>> neighbours;  ///< per left segment
  double gsd_m = 0.0;
  double same_height_m = 0.0;  ///< lines that meet in the image are this close in height
};

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

void add_row_rivals(VoteGraph& graph, const MatchChoices& choices) {
  for (std::size_t i = 0; i + 1 < graph.first.size(); ++i) {
    for (Flat a = graph.first[i]; a < graph.first[i + 1]; ++a) {
      for (Flat b = graph.first[i]; b < graph.first[i + 1]; ++b) {
        if (a == b) continue;
        if (!are_fragments(choices.mate(*graph.candidates[a]),
                           choices.mate(*graph.candidates[b]))) {
          graph.rivals[a].push_back(b);
        }
      }
    }
  }
}

void add_column_rivals(VoteGraph& graph, const MatchChoices& choices) {
  const auto part = [&](Flat c) { return choices.on_left(graph.left[c], *graph.candidates[c]); };
  std::vector<std::vector<Flat>> of_right(choices.right.segments.size());
  for (Flat c = 0; c < static_cast<Flat>(graph.candidates.size()); ++c) {
    of_right[graph.candidates[c]->right].push_back(c);
  }
  for (const std::vector<Flat>& column : of_right) {
    for (const Flat a : column) {
      for (const Flat b : column) {
        if (a != b && !may_share_mate(part(a), part(b))) graph.rivals[a].push_back(b);
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

std::vector<NearSegment> neighbours_of(int segment,
                                       std::span<const Segment2> segments,
                                       const SegmentIndex& index) {
  constexpr double kReach_px = 60.0;
  constexpr std::size_t kMost = 12;
  const Segment2& own = segments[segment];
  std::vector<NearSegment> neighbours;
  for (const int other : index.near(own, kReach_px)) {
    if (other == segment) continue;
    const NearSegment neighbour = closest(own, other, segments[other]);
    if (neighbour.distance_px <= kReach_px) neighbours.push_back(neighbour);
  }
  std::ranges::stable_sort(neighbours, {}, &NearSegment::distance_px);
  if (neighbours.size() > kMost) neighbours.resize(kMost);
  return neighbours;
}

void add_neighbours(VoteGraph& graph, const View& left) {
  const std::vector<Segment2> segments = ideal_segments(left);
  const SegmentIndex index(segments);
  graph.neighbours.resize(segments.size());
  tbb::parallel_for(std::size_t{0}, segments.size(), [&](std::size_t i) {
    graph.neighbours[i] = neighbours_of(static_cast<int>(i), segments, index);
  });
}

VoteGraph build_graph(const MatchChoices& choices,
                      std::span<const PairMatch> pairs,
                      const LocalTransfer& transfer) {
  constexpr double kGutters_m = 0.6;  // and other things between edges that meet
  constexpr double kNoise_px = 2.0;   // of parallax
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

double best_probability(const VoteGraph& graph, std::span<const double> probability, int segment) {
  double best = 0.0;
  for (Flat c = graph.first[segment]; c < graph.first[segment + 1]; ++c) {
    best = std::max(best, probability[c]);
  }
  return best;
}

void add_votes(const VoteGraph& graph,
               std::span<const double> probability,
               Flat candidate,
               Support& support) {
  constexpr double kSupporting = 0.25;  // a vote from here on counts as a pair
  const std::vector<Link>& links = graph.links[candidate];
  double possible = 0.0;
  for (std::size_t begin = 0; begin < links.size();) {
    double best = 0.0;
    std::size_t end = begin;
    for (; end < links.size() && links[end].partner == links[begin].partner; ++end) {
      best = std::max(best, links[end].vote * probability[links[end].candidate]);
    }
    possible += best_probability(graph, probability, links[begin].partner);
    support.votes += best;
    if (best >= kSupporting) ++support.n_pairs;
    begin = end;
  }
  support.vote_share = (support.votes + kLittle * kUndecided) / (possible + kLittle);
}

double height_support(const VoteGraph& graph, std::span<const double> probability, Flat candidate) {
  constexpr double kNear_px = 12.0;
  constexpr double kSlope = 0.7;
  const EpipolarOverlap& own = graph.candidates[candidate]->overlap;
  if (own.aligned) return kUndecided;  // its height is what nobody knows yet
  double all = kLittle;
  double agreeing = kLittle * kUndecided;
  for (const NearSegment& neighbour : graph.neighbours[graph.left[candidate]]) {
    const double z = own.height_at(neighbour.own_t);
    const double weight = std::exp(-neighbour.distance_px / kNear_px);
    const double spread_m = graph.same_height_m + kSlope * graph.gsd_m * neighbour.distance_px;
    for (Flat c = graph.first[neighbour.segment]; c < graph.first[neighbour.segment + 1]; ++c) {
      if (graph.candidates[c]->overlap.aligned) continue;
      const double apart = (graph.candidates[c]->overlap.height_at(neighbour.t) - z) / spread_m;
      agreeing += weight * probability[c] * std::exp(-0.5 * apart * apart);
      all += weight * probability[c];
    }
  }
  return agreeing / all;
}

/// Strength e^T of a candidate: odds of being right before its rivals are looked at.
double strength(const Candidate& candidate, const Support& support) {
  constexpr double kBias = -3.5;
  constexpr double kLook = 0.8;
  constexpr double kVoteShare = 4.0;
  constexpr double kHeight = 7.2;
  const double u = std::clamp(candidate.similarity, 1e-6, 1.0 - 1e-6);
  return std::exp(kBias + kLook * std::log(u / (1.0 - u)) + kVoteShare * support.vote_share +
                  kHeight * support.height + candidate.log_odds);
}

}  // namespace

Supports similarity_votes(const MatchChoices& choices,
                          std::span<const PairMatch> pairs,
                          const LocalTransfer& transfer) {
  const VoteGraph graph = build_graph(choices, pairs, transfer);
  const std::size_t n = graph.candidates.size();
  std::vector<Support> supports(n);
  std::vector<double> probability(n);
  std::vector<double> strengths(n);
  for (std::size_t c = 0; c < n; ++c) probability[c] = graph.candidates[c]->similarity;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    tbb::parallel_for(std::size_t{0}, n, [&](std::size_t c) {
      Interruption::check();
      Support support;
      add_votes(graph, probability, static_cast<Flat>(c), support);
      support.height = height_support(graph, probability, static_cast<Flat>(c));
      strengths[c] = strength(*graph.candidates[c], support);
      supports[c] = support;
    });
    double change = 0.0;
    for (std::size_t c = 0; c < n; ++c) {
      double rivals = 0.0;
      for (const Flat rival : graph.rivals[c]) rivals += strengths[rival];
      const double next = strengths[c] / (1.0 + strengths[c] + rivals);
      change = std::max(change, std::abs(next - probability[c]));
      probability[c] = next;
      supports[c].probability = next;
    }
    if (change < kFixedPoint) break;
  }
  Supports by_segment(choices.candidates.size());
  for (std::size_t i = 0; i < by_segment.size(); ++i) {
    by_segment[i].assign(supports.begin() + graph.first[i], supports.begin() + graph.first[i + 1]);
  }
  return by_segment;
}

}  // namespace ridgeline::reconstruct
