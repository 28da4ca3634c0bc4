// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/network.h"

#include "reconstruct/estimate/beyond/network/adjustment.h"
#include "reconstruct/geometry/disjoint_sets.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/geometry/transformed.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ridgeline::reconstruct {
namespace {

constexpr int kMaxAdjustmentPasses = 30;
constexpr double kConverged = 1e-6;  // in standard deviations, as in adjust_line()

/// Lines that a chain of meetings connects, ascending, and their meetings.
struct ConnectedLines {
  std::vector<int> lines;
  std::vector<Meeting> meetings;  ///< their lines are indices into ConnectedLines::lines
};

std::vector<ConnectedLines> connected_groups(std::size_t n_lines,
                                             std::span<const Meeting> meetings) {
  DisjointSets sets(n_lines);
  for (const Meeting& m : meetings) {
    sets.join(static_cast<std::size_t>(m.first), static_cast<std::size_t>(m.second));
  }
  std::map<std::size_t, ConnectedLines> groups;
  std::vector<int> place(n_lines);
  for (std::size_t i = 0; i < n_lines; ++i) {
    std::vector<int>& lines = groups[sets.name_of(i)].lines;
    place[i] = static_cast<int>(lines.size());
    lines.push_back(static_cast<int>(i));
  }
  for (const Meeting& m : meetings) {
    groups[sets.name_of(static_cast<std::size_t>(m.first))].meetings.push_back(
        {place[m.first], place[m.second], m.junction});
  }
  std::vector<ConnectedLines> result;
  for (auto& [name, group] : groups) {
    if (!group.meetings.empty()) result.push_back(std::move(group));
  }
  return result;
}

double square(double x) { return x * x; }

/// Posterior probability that two lines meet, given the miss predicted from everything else. The
/// miss is normally distributed if they meet, and otherwise about uniform over max_miss_m.
double probability(const Junction& junction,
                   const NetworkAdjustment::Prediction& predicted,
                   const BuildingOptions& options) {
  const double prior = junction.prior;
  if (!std::isfinite(predicted.sigma)) return prior;
  const double widest = options.max_miss_m / junction.sigma_m;
  const double of_lines = 2.0 * std::numbers::pi * square(predicted.sigma);
  const double variance = 1.0 + square(predicted.sigma);
  const double inlier = std::exp(-0.5 * square(predicted.miss) / variance) /
                        std::sqrt(2.0 * std::numbers::pi + of_lines);
  const double outlier = 1.0 / std::sqrt(square(widest) + of_lines);
  return prior * inlier / (prior * inlier + (1.0 - prior) * outlier);
}

/// Expectation maximisation over whether the lines meet: each meeting is weighted by its
/// probability, given all others at their weights. A meeting that is improbable for the two lines
/// alone is never used, because false meetings of one line, for example of a road marking with the
/// cars beside it, would support each other. The final decision on the meetings is made at the end.
/// Returns false if the equations are singular.
bool decide_meetings(NetworkAdjustment& adjustment, const BuildingOptions& options) {
  constexpr int kMaxRounds = 20;
  constexpr double kSettled = 1e-3;      // largest change of a weight
  constexpr double kNearMinimum = 1e-2;  // in standard deviations
  constexpr double kAccepted = 0.5;      // probability
  const std::size_t n = adjustment.meetings().size();
  std::vector<bool> is_possible(n, true);
  for (int round = 0; round < kMaxRounds; ++round) {
    std::vector<double> weights(n);
    double change = 0.0;
    for (std::size_t m = 0; m < n; ++m) {
      weights[m] = probability(
          adjustment.meetings()[m].junction,
          round == 0 ? adjustment.predicted_at_start(m) : adjustment.predicted(m), options);
      if (round == 0) is_possible[m] = weights[m] >= kAccepted;
      if (!is_possible[m]) weights[m] = 0.0;
      change = std::max(change, std::abs(weights[m] - adjustment.weights[m]));
    }
    adjustment.weights = weights;
    if (!adjustment.minimise(kNearMinimum, kMaxAdjustmentPasses) || !adjustment.invert())
      return false;
    if (change < kSettled) break;
  }
  for (double& weight : adjustment.weights) weight = weight >= kAccepted ? 1.0 : 0.0;
  return adjustment.minimise(kConverged, kMaxAdjustmentPasses);
}

/// Stores the results of a group if its adjustment has converged; returns whether it has.
bool take_results(const ConnectedLines& group,
                  NetworkAdjustment& adjustment,
                  std::vector<AdjustedInNetwork>& results) {
  if (!adjustment.converged() || !adjustment.invert()) return false;
  for (std::size_t i = 0; i < group.lines.size(); ++i) {
    AdjustedInNetwork& result = results[group.lines[i]];
    result.line = {adjustment.estimate(i), adjustment.covariance(i)};
    result.omega = adjustment.image_omega(i);
    result.adjusted = result.line.mean.allFinite() && result.line.cov.allFinite();
  }
  for (std::size_t m = 0; m < group.meetings.size(); ++m) {
    if (adjustment.weights[m] == 0.0) continue;
    ++results[group.lines[group.meetings[m].first]].n_meetings;
    ++results[group.lines[group.meetings[m].second]].n_meetings;
  }
  return true;
}

/// The parts of a group that its accepted meetings connect.
std::vector<ConnectedLines> accepted_parts(const ConnectedLines& group,
                                           const NetworkAdjustment& adjustment) {
  std::vector<Meeting> accepted;
  for (std::size_t m = 0; m < group.meetings.size(); ++m) {
    if (adjustment.weights[m] > 0.0) accepted.push_back(group.meetings[m]);
  }
  std::vector<ConnectedLines> parts = connected_groups(group.lines.size(), accepted);
  for (ConnectedLines& part : parts) {
    for (int& line : part.lines) line = group.lines[line];
  }
  return parts;
}

void adjust_group(const ConditionedViews& frames,
                  std::span<const NetworkLine> lines,
                  const ConnectedLines& group,
                  const std::array<double, 2>& heights_m,
                  const BuildingOptions& options,
                  std::vector<AdjustedInNetwork>& results) {
  const auto adjustment_of = [&](const ConnectedLines& some) {
    return NetworkAdjustment(frames,
                             transformed(some.lines, [&](int line) { return &lines[line]; }),
                             some.meetings, heights_m, options.sigma_slope);
  };
  NetworkAdjustment adjustment = adjustment_of(group);
  if (!decide_meetings(adjustment, options) || take_results(group, adjustment, results)) return;
  // A line that does not converge because its images contradict each other only spoils its own
  // part.
  for (const ConnectedLines& part : accepted_parts(group, adjustment)) {
    NetworkAdjustment alone = adjustment_of(part);
    if (alone.minimise(kConverged, kMaxAdjustmentPasses)) take_results(part, alone, results);
  }
}

}  // namespace

std::vector<AdjustedInNetwork> adjust_network(const ConditionedViews& frames,
                                              std::span<const NetworkLine> lines,
                                              std::span<const Meeting> meetings,
                                              const std::array<double, 2>& heights_m,
                                              const BuildingOptions& options) {
  std::vector<AdjustedInNetwork> results(lines.size());
  const std::vector<ConnectedLines> groups = connected_groups(lines.size(), meetings);
  tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t g) {
    Interruption::check();
    adjust_group(frames, lines, groups[g], heights_m, options, results);
  });
  return results;
}

}  // namespace ridgeline::reconstruct
