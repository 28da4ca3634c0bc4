// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/depth_consensus/depth_profiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

constexpr double kMinStepLengthPx = 15.0;
constexpr double kUnreached = -std::numeric_limits<double>::infinity();

double squared(double x) { return x * x; }

/// Density of the slope of lines that are not built horizontal: mostly roofs of 20 to 50 degrees,
/// but also streets.
double sloping(double slope) {
  constexpr double kRoof = 0.7, kRoofScatter = 0.3, kRoofShare = 0.9, kStreet = 0.6;
  return kRoofShare * bell((slope - kRoof) / kRoofScatter) +
         (1.0 - kRoofShare) * bell(slope / kStreet);
}

double log_straight_prior(double slope, const BuildingOptions& options) {
  constexpr double kHorizontal = 0.8;  // share of aligned lines that are built horizontal
  return std::log(kHorizontal * bell(slope / options.sigma_slope) +
                  (1.0 - kHorizontal) * sloping(slope));
}

/// Logarithm of the prior of a cut between two steps of a row. A row that has one step often has
/// more.
double log_step_prior(bool is_first, const ConsensusOptions& options) {
  constexpr double kNextShare = 0.3;
  return std::log(is_first ? options.step_share : kNextShare);
}

/// Logarithm of the prior of the height of a step. Steps are low, because the houses of a row
/// follow the street, and the ground below does not cut an eave.
double log_rise_prior(double rise_m) {
  constexpr double kRise_m = 1.0;
  return -0.5 * squared(rise_m / kRise_m);
}

/// Indices of the evidence at which the track may be cut, in order along it; one for all evidence
/// at the same position.
std::vector<std::size_t> places_to_cut(const DepthQuestion& question, const DepthScorer& scorer) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < question.evidence.size(); ++i) {
    if (question.evidence[i].may_cut) places.push_back(i);
  }
  std::ranges::stable_sort(places, {}, [&](auto i) { return question.evidence[i].parameter; });
  const auto same = [&](std::size_t a, std::size_t b) {
    return scorer.is_at(a, question.evidence[b]);
  };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  return places;
}

/// The best horizontal line between two cuts.
struct DepthStep {
  double score = kUnreached;
  DepthLine line;
};

/// The best horizontal line between two cuts.
/// @param from, to  cuts; empty at the ends of the track
DepthStep best_step(const DepthQuestion& question,
                    const DepthScorer& scorer,
                    std::optional<std::size_t> from,
                    std::optional<std::size_t> to) {
  const auto is_cut = [&](const DepthEvidence& e) {
    return (from && scorer.is_at(*from, e)) || (to && scorer.is_at(*to, e));
  };
  const auto is_between = [&](const DepthEvidence& e) {
    return (!from || e.parameter > question.evidence[*from].parameter) &&
           (!to || e.parameter < question.evidence[*to].parameter);
  };
  DepthStep best;
  for (const DepthEvidence& e : question.evidence) {
    if (!is_cut(e) && !is_between(e)) continue;
    DepthStep step{0.0, {e.x, scorer.horizontal()}};
    for (const DepthEvidence& other : question.evidence) {
      if (is_cut(other)) {
        step.score += scorer.score_near_cut(other, step.line);
      } else if (is_between(other)) {
        step.score += scorer.score(other, step.line);
      }
    }
    if (!from) step.score += scorer.score_of_end(0, step.line);
    if (!to) step.score += scorer.score_of_end(1, step.line);
    if (step.score > best.score) best = step;
  }
  return best;
}

/// Whether a step is long enough to be a house rather than the bonnet of a car beside a road
/// marking.
bool is_long_step(const DepthQuestion& question,
                  std::optional<std::size_t> from,
                  std::optional<std::size_t> to) {
  const double start = from ? question.evidence[*from].parameter : 0.0;
  const double end = to ? question.evidence[*to].parameter : 1.0;
  const double px = question.lines.frames.of(question.line.base()).image.scale_px *
                    length(question.line.base().segment);
  return (end - start) * px >= kMinStepLengthPx;
}

/// The score of a cut's evidence, minus the scores that best_step() has counted for it on either
/// side.
double score_of_cut_once(const DepthQuestion& question,
                         const DepthScorer& scorer,
                         std::size_t cut,
                         const DepthLine& before,
                         const DepthLine& after) {
  const DepthEvidence& e = question.evidence[cut];
  return scorer.score_of_cut(cut, before, after) - scorer.score_near_cut(e, before) -
         scorer.score_near_cut(e, after);
}

/// The best row from the start of the track to a possible cut.
struct Way {
  double score = kUnreached;
  double log_prior = 0.0;  ///< contribution of the prior to the score
  std::size_t from = 0;    ///< the cut where the last step begins
  DepthLine line;          ///< line of the last step
};

}  // namespace

std::vector<DepthProfile> straight_profiles(const DepthQuestion& question,
                                            const DepthScorer& scorer) {
  const std::span<const DepthEvidence> evidence = question.evidence;
  std::vector<DepthProfile> all;
  const auto add = [&](const Eigen::Vector3d& through, const Eigen::Vector3d& direction) {
    all.push_back(
        {{{through, direction}}, {}, log_straight_prior(slope(direction), question.building)});
  };
  const Eigen::Vector3d horizontal = scorer.horizontal();
  for (std::size_t a = 0; a < evidence.size(); ++a) {
    if (!horizontal.isZero()) add(evidence[a].x, horizontal);
    for (std::size_t b = a + 1; b < evidence.size(); ++b) {
      if (std::abs(evidence[a].parameter - evidence[b].parameter) < kMinBase) continue;
      add(evidence[a].x, scorer.in_plane(evidence[b].x - evidence[a].x));
    }
  }
  if (question.surface != nullptr) {
    for (const DepthLine& line : question.surface->likely_lines(horizontal)) {
      add(line.through, line.direction);
    }
  }
  return all;
}

std::vector<DepthProfile> gable_profiles(const DepthQuestion& question, const DepthScorer& scorer) {
  constexpr double kMinSlope = 0.2, kMaxSlope = 1.7;
  constexpr double kFeet_m = 0.4;
  std::vector<DepthProfile> all;
  if (!(question.options.gable_share > 0.0)) return all;
  for (const std::size_t top : places_to_cut(question, scorer)) {
    const DepthEvidence& ridge = question.evidence[top];
    for (const DepthEvidence& foot : question.evidence) {
      const double away = foot.parameter - ridge.parameter;
      if (std::abs(away) < kMinBase || foot.x.z() >= ridge.x.z()) continue;
      const Eigen::Vector3d down = scorer.in_plane(foot.x - ridge.x);
      if (slope(down) < kMinSlope || slope(down) > kMaxSlope) continue;
      const DepthLine seen{ridge.x, down};
      const DepthLine opposite{ridge.x, scorer.mirrored(down)};
      DepthProfile gable;
      gable.lines = {away < 0.0 ? seen : opposite, away < 0.0 ? opposite : seen};
      gable.cuts = {top};
      gable.log_prior = std::log(question.options.gable_share * sloping(slope(down))) -
                        0.5 * squared(scorer.difference_of_ends_m(gable) / kFeet_m);
      all.push_back(gable);
    }
  }
  return all;
}

std::optional<DepthProfile> row_profile(const DepthQuestion& question, const DepthScorer& scorer) {
  const std::vector<std::size_t> places = places_to_cut(question, scorer);
  if (places.empty() || scorer.horizontal().isZero() || !(question.options.step_share > 0.0)) {
    return std::nullopt;
  }
  const std::size_t end = places.size() + 1;
  const auto cut = [&](std::size_t place) {
    return place == 0 || place == end ? std::nullopt : std::optional(places[place - 1]);
  };
  // The best way to each place follows from the best ways to the places before it. The last place
  // is the end of the track.
  std::vector<Way> ways(end + 1);
  ways[0].score = 0.0;
  for (std::size_t to = 1; to <= end; ++to) {
    for (std::size_t from = 0; from < to; ++from) {
      if (from == 0 && to == end) continue;
      const Way& before = ways[from];
      if (before.score == kUnreached || !is_long_step(question, cut(from), cut(to))) continue;
      const DepthStep step = best_step(question, scorer, cut(from), cut(to));
      double log_prior = before.log_prior;
      if (from > 0) {
        log_prior += log_step_prior(before.from == 0, question.options) +
                     log_rise_prior(scorer.rise_m(before.line, step.line));
      }
      double score = before.score - before.log_prior + step.score + log_prior;
      if (from > 0) {
        score += score_of_cut_once(question, scorer, *cut(from), before.line, step.line);
      }
      if (score > ways[to].score) ways[to] = {score, log_prior, from, step.line};
    }
  }
  if (ways[end].score == kUnreached) return std::nullopt;
  DepthProfile row;
  row.log_prior = ways[end].log_prior;
  for (std::size_t to = end; to > 0; to = ways[to].from) {
    row.lines.push_back(ways[to].line);
    if (to < end) row.cuts.push_back(places[to - 1]);
  }
  std::reverse(row.lines.begin(), row.lines.end());
  std::reverse(row.cuts.begin(), row.cuts.end());
  return row;
}

}  // namespace ridgeline::reconstruct
