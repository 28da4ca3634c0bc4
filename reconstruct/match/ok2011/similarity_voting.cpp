// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/similarity_voting.h"

#include "reconstruct/geometry/interruption.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/match/ok2011/vote_graph.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr int kMaxVotingPasses = 20;
constexpr double kFixedPoint = 1e-4;  // the passes end when no probability changes by this much
/// A share of support starts from "undecided" with this weight, because a lone neighbour proves
/// little and a segment without neighbours is judged by its appearance.
constexpr double kLittle = 0.5;
constexpr double kUndecided = 0.5;

/// The probability of the likeliest candidate of a left segment.
double best_probability(const VoteGraph& graph, std::span<const double> probability, int segment) {
  double best = 0.0;
  for (Flat c = graph.first[segment]; c < graph.first[segment + 1]; ++c) {
    best = std::max(best, probability[c]);
  }
  return best;
}

/// Adds up the votes for a candidate. Each partner gives the vote of its best pair.
void add_votes(const VoteGraph& graph,
               std::span<const double> probability,
               Flat candidate,
               Support& support) {
  constexpr double kSupporting = 0.25;  // the smallest vote that counts as a pair
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

/// The share of the neighbours that are at the height of a candidate.
double height_support(const VoteGraph& graph, std::span<const double> probability, Flat candidate) {
  constexpr double kNear_px = 12.0;
  constexpr double kSlope = 0.7;
  const EpipolarOverlap& own = graph.candidates[candidate]->overlap;
  if (own.aligned) return kUndecided;  // the images do not determine the height of an aligned line
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

/// Strength e^T of a candidate: its odds of being correct before its rivals are considered.
double strength(const Candidate& candidate, const Support& support) {
  constexpr double kBias = -3.5;
  constexpr double kLook = 0.8;
  constexpr double kVoteShare = 4.0;
  constexpr double kHeight = 7.2;
  const double u = std::clamp(candidate.similarity, 1e-6, 1.0 - 1e-6);
  return std::exp(kBias + kLook * std::log(u / (1.0 - u)) + kVoteShare * support.vote_share +
                  kHeight * support.height + candidate.log_odds);
}

/// The support of every candidate for the given probabilities of the candidates.
std::vector<Support> supports_at(const VoteGraph& graph, std::span<const double> probability) {
  std::vector<Support> supports(probability.size());
  tbb::parallel_for(std::size_t{0}, supports.size(), [&](std::size_t c) {
    Interruption::check();
    const auto candidate = static_cast<Flat>(c);
    add_votes(graph, probability, candidate, supports[c]);
    supports[c].height = height_support(graph, probability, candidate);
  });
  return supports;
}

/// The probability of every candidate: its strength relative to that of its rivals.
std::vector<double> probabilities(const VoteGraph& graph, std::span<const Support> supports) {
  std::vector<double> strengths(supports.size());
  tbb::parallel_for(std::size_t{0}, strengths.size(), [&](std::size_t c) {
    strengths[c] = strength(*graph.candidates[c], supports[c]);
  });
  std::vector<double> probability(strengths.size());
  for (std::size_t c = 0; c < strengths.size(); ++c) {
    double rivals = 0.0;
    for (const Flat rival : graph.rivals[c]) rivals += strengths[rival];
    probability[c] = strengths[c] / (1.0 + strengths[c] + rivals);
  }
  return probability;
}

double largest_change(std::span<const double> before, std::span<const double> after) {
  double change = 0.0;
  for (std::size_t c = 0; c < after.size(); ++c)
    change = std::max(change, std::abs(after[c] - before[c]));
  return change;
}

}  // namespace

Supports similarity_votes(const MatchChoices& choices,
                          std::span<const PairMatch> pairs,
                          const LocalTransfer& transfer) {
  const VoteGraph graph = vote_graph(choices, pairs, transfer);
  std::vector<double> probability =
      transformed(graph.candidates, [](const Candidate* c) { return c->similarity; });
  std::vector<Support> supports;
  for (int pass = 0; pass < kMaxVotingPasses; ++pass) {
    supports = supports_at(graph, probability);
    std::vector<double> next = probabilities(graph, supports);
    const double change = largest_change(probability, next);
    probability = std::move(next);
    if (change < kFixedPoint) break;
  }
  for (std::size_t c = 0; c < supports.size(); ++c) supports[c].probability = probability[c];
  Supports by_segment(choices.candidates.size());
  for (std::size_t i = 0; i < by_segment.size(); ++i) {
    by_segment[i].assign(supports.begin() + graph.first[i], supports.begin() + graph.first[i + 1]);
  }
  return by_segment;
}

}  // namespace ridgeline::reconstruct
