// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/network/network.h"

#include "reconstruct/beyond/network/adjustment.h"

#include <Eigen/Eigenvalues>
#include <boost/pending/disjoint_sets.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ridgeline::reconstruct {
namespace {

constexpr int kMostPasses = 30;
constexpr double kConverged = 1e-6;  // in standard deviations; as in adjust_line()

/// Lines that a chain of meetings connects, ascending, and their meetings.
struct Group {
  std::vector<int> lines;
  std::vector<Meeting> meetings;  ///< by place in `lines`
};

std::vector<Group> connected_groups(std::size_t n_lines, std::span<const Meeting> meetings) {
  boost::disjoint_sets_with_storage<> sets(n_lines);
  for (const Meeting& m : meetings) {
    sets.union_set(static_cast<std::size_t>(m.first), static_cast<std::size_t>(m.second));
  }
  std::map<std::size_t, Group> groups;
  std::vector<int> place(n_lines);
  for (std::size_t i = 0; i < n_lines; ++i) {
    std::vector<int>& lines = groups[sets.find_set(i)].lines;
    place[i] = static_cast<int>(lines.size());
    lines.push_back(static_cast<int>(i));
  }
  for (const Meeting& m : meetings) {
    groups[sets.find_set(static_cast<std::size_t>(m.first))].meetings.push_back(
        {place[m.first], place[m.second], m.junction});
  }
  std::vector<Group> result;
  for (auto& [root, group] : groups) {
    if (!group.meetings.empty()) result.push_back(std::move(group));
  }
  return result;
}

double squared(double x) { return x * x; }

/// Posterior probability that two lines meet, by how far everything else predicts that they miss each
/// other: normal if they meet, else about uniform over max_miss_m.
double probability(const Junction& junction,
                   const NetworkAdjustment::Prediction& predicted,
                   const EstimateExtensionOptions& options) {
  const double prior = junction.prior;
  if (!std::isfinite(predicted.sigma)) return prior;
  const double widest = options.max_miss_m / junction.sigma_m;
  const double of_lines = 2.0 * std::numbers::pi * squared(predicted.sigma);
  const double variance = 1.0 + squared(predicted.sigma);
  const double inlier = std::exp(-0.5 * squared(predicted.miss) / variance) /
                        std::sqrt(2.0 * std::numbers::pi + of_lines);
  const double outlier = 1.0 / std::sqrt(squared(widest) + of_lines);
  return prior * inlier / (prior * inlier + (1.0 - prior) * outlier);
}

/// Expectation maximisation over whether the lines meet: each meeting is weighted by its probability,
/// given all others at their weights. What the two lines by themselves make improbable stays out: false
/// meetings of one line, as of a road marking with the cars beside it, would support each other. Decided at
/// the end.
bool decide_meetings(NetworkAdjustment& adjustment, const EstimateExtensionOptions& options) {
  constexpr int kMostRounds = 20;
  constexpr double kSettled = 1e-3;      // largest change of a weight
  constexpr double kNearMinimum = 1e-2;  // in standard deviations
  constexpr double kLeastAtStart = 0.3;  // probability
  const std::size_t n = adjustment.meetings().size();
  std::vector<bool> is_possible(n, true);
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<double> weights(n);
    double change = 0.0;
    for (std::size_t m = 0; m < n; ++m) {
      weights[m] = probability(
          adjustment.meetings()[m].junction,
          round == 0 ? adjustment.predicted_at_start(m) : adjustment.predicted(m), options);
      if (round == 0) is_possible[m] = weights[m] >= kLeastAtStart;
      if (!is_possible[m]) weights[m] = 0.0;
      change = std::max(change, std::abs(weights[m] - adjustment.weights[m]));
    }
    adjustment.weights = weights;
    if (!adjustment.minimise(kNearMinimum, kMostPasses) || !adjustment.invert()) return false;
    if (change < kSettled) break;
  }
  for (double& weight : adjustment.weights) weight = weight >= 0.5 ? 1.0 : 0.0;
  return adjustment.minimise(kConverged, kMostPasses);
}

/// |w| of each accepted meeting, Baarda's normalised residual: its predicted miss over the standard
/// deviation of that and of a meeting. 0 where the others hardly control it.
std::vector<double> residual_tests(const NetworkAdjustment& adjustment) {
  constexpr double kLeastRedundancy = 0.1;
  std::vector<double> w(adjustment.weights.size(), 0.0);
  for (std::size_t m = 0; m < w.size(); ++m) {
    if (adjustment.weights[m] == 0.0) continue;
    const NetworkAdjustment::Prediction predicted = adjustment.predicted(m);
    const double variance = 1.0 + squared(predicted.sigma);
    if (1.0 / variance >= kLeastRedundancy) w[m] = std::abs(predicted.miss) / std::sqrt(variance);
  }
  return w;
}

/// Rejects meetings beyond chance, in each round those with the largest residual of both lines: a
/// false one spoils the others of its lines.
bool reject_false_meetings(NetworkAdjustment& adjustment) {
  constexpr double kLimit = 3.29;  // 0.1 %
  constexpr int kMostRounds = 20;
  for (int round = 0; round < kMostRounds; ++round) {
    if (!adjustment.invert()) return false;
    const std::vector<double> w = residual_tests(adjustment);
    std::vector<double> largest(adjustment.n_lines(), 0.0);
    for (std::size_t m = 0; m < w.size(); ++m) {
      for (const int line : {adjustment.meetings()[m].first, adjustment.meetings()[m].second}) {
        largest[line] = std::max(largest[line], w[m]);
      }
    }
    bool rejected = false;
    for (std::size_t m = 0; m < w.size(); ++m) {
      const Meeting& meeting = adjustment.meetings()[m];
      if (w[m] <= kLimit || w[m] < largest[meeting.first] || w[m] < largest[meeting.second])
        continue;
      adjustment.weights[m] = 0.0;
      rejected = true;
    }
    if (!rejected) return true;
    if (!adjustment.minimise(kConverged, kMostPasses)) return false;
  }
  return true;
}

/// Whether a line has moved farther from the intersection of its projection planes than chance allows:
/// T = d' (cov_images - cov)^+ d of the shift d, in the directions in which the meetings say anything.
bool contradicts_images(const NetworkLine& line, const Vector6d& estimate, const Matrix6d& cov) {
  constexpr double kSmallest = 1e-6;  // eigenvalue, of the largest of the covariance by the images
  constexpr std::array<double, 5> kChiSquare999{0.0, 10.83, 13.82, 16.27, 18.47};
  const auto by_images = intersection(line.seen[0].plane, line.seen[1].plane);
  if (!by_images) return false;
  const Eigen::Matrix<double, 6, 4> basis = line_tangent_basis(by_images->mean);
  const double sign = by_images->mean.dot(estimate) < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector4d shift = basis.transpose() * (sign * estimate - by_images->mean);
  const Eigen::Matrix4d cov_images = basis.transpose() * by_images->cov * basis;
  const Eigen::Matrix4d cov_shift = cov_images - basis.transpose() * cov * basis;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(cov_shift);
  const double least =
      kSmallest * Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(cov_images).eigenvalues()(3);
  double t = 0.0;
  std::size_t rank = 0;
  for (int i = 0; i < 4; ++i) {
    if (eigen.eigenvalues()(i) <= least) continue;
    t += squared(eigen.eigenvectors().col(i).dot(shift)) / eigen.eigenvalues()(i);
    ++rank;
  }
  return t > kChiSquare999.at(rank);
}

/// Drops the worst meeting of each guarded line that contradicts its images, until none does.
/// `has_dropped`: lines that have lost one at least.
bool guard(NetworkAdjustment& adjustment, std::vector<bool>& has_dropped) {
  const std::size_t n = adjustment.n_lines();
  while (true) {
    if (!adjustment.invert()) return false;
    std::vector<double> worst(n, -1.0);
    std::vector<std::size_t> meeting(n, 0);
    for (std::size_t m = 0; m < adjustment.weights.size(); ++m) {
      if (adjustment.weights[m] == 0.0) continue;
      const double miss = std::abs(adjustment.miss(m));
      for (const int line : {adjustment.meetings()[m].first, adjustment.meetings()[m].second}) {
        if (miss <= worst[line]) continue;
        worst[line] = miss;
        meeting[line] = m;
      }
    }
    bool dropped = false;
    for (std::size_t i = 0; i < n; ++i) {
      if (!adjustment.line(i).is_guarded || worst[i] < 0.0) continue;
      if (!contradicts_images(adjustment.line(i), adjustment.estimate(i), adjustment.covariance(i)))
        continue;
      adjustment.weights[meeting[i]] = 0.0;
      has_dropped[i] = true;
      dropped = true;
    }
    if (!dropped) return true;
    if (!adjustment.minimise(kConverged, kMostPasses)) return false;
  }
}

void adjust_group(const StereoViews& stereo,
                  std::span<const NetworkLine> lines,
                  const Group& group,
                  const std::array<double, 2>& heights_m,
                  const EstimateExtensionOptions& options,
                  std::vector<AdjustedInNetwork>& results) {
  std::vector<const NetworkLine*> members;
  for (const int line : group.lines) members.push_back(&lines[line]);
  NetworkAdjustment adjustment(stereo, members, group.meetings, heights_m, options.sigma_slope);
  std::vector<bool> has_dropped(members.size(), false);
  if (!decide_meetings(adjustment, options) || !reject_false_meetings(adjustment) ||
      !guard(adjustment, has_dropped) || !adjustment.converged()) {
    return;
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
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
  for (std::size_t i = 0; i < members.size(); ++i) {
    AdjustedInNetwork& result = results[group.lines[i]];
    result.guard_reverted = has_dropped[i] && result.n_meetings == 0;
  }
}

}  // namespace

std::vector<AdjustedInNetwork> adjust_network(const StereoViews& stereo,
                                              std::span<const NetworkLine> lines,
                                              std::span<const Meeting> meetings,
                                              const std::array<double, 2>& heights_m,
                                              const EstimateExtensionOptions& options) {
  std::vector<AdjustedInNetwork> results(lines.size());
  const std::vector<Group> groups = connected_groups(lines.size(), meetings);
  tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t g) {
    adjust_group(stereo, lines, groups[g], heights_m, options, results);
  });
  return results;
}

}  // namespace ridgeline::reconstruct
