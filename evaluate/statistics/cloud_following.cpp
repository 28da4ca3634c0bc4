// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/cloud_following.h"

#include "evaluate/judge/segment_plane.h"
#include "reconstruct/geometry/check.h"

#include <cmath>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// Height of the surface at the middle of the line; for a ridge, the mean of both planes.
double surface_height_m(const Segment3& line, const std::vector<JudgingPlane>& planes) {
  double sum_m = 0.0;
  for (const JudgingPlane& p : planes) sum_m += height_at(p.plane, midpoint(plan(line)));
  return sum_m / static_cast<double>(planes.size());
}

double mean_distance_of(const Segment3& line, const std::vector<JudgingPlane>& planes) {
  double sum_m = 0.0;
  for (const JudgingPlane& p : planes) sum_m += orthogonal_distance(line, p.plane).mean_abs;
  return sum_m / static_cast<double>(planes.size());
}

/// Whether a line fits in its own position and elsewhere, for positions that the cloud can
/// distinguish.
struct PlacePair {
  bool fits = false, fits_elsewhere = false;
};

bool is_judged(const LineEvaluation& line) {
  return line.status == Status::kEvaluated && !line.planes.empty();
}

std::optional<PlacePair> pair_of(const Segment3& line,
                                 const LineEvaluation& here,
                                 const JudgedDecoy& moved,
                                 const Eigen::Vector3d& shift_m) {
  const LineEvaluation& there = moved.evaluation;
  if (!is_judged(here) || !is_judged(there)) return std::nullopt;
  const Segment3& elsewhere = moved.decoy.line.segment;
  const double step_m =
      surface_height_m(elsewhere, there.planes) - surface_height_m(line, here.planes);
  if (!(std::abs(step_m) > 2.0 * kRight_m)) return std::nullopt;  // also for NaN
  const auto fits = [&](const Segment3& s, const LineEvaluation& judged) {
    return mean_distance_of({s.start - shift_m, s.end - shift_m}, judged.planes) < kRight_m;
  };
  return PlacePair{fits(line, here), fits(elsewhere, there)};
}

/// Interval of the mean of (fits here) - (fits there).
std::optional<Interval> difference_interval(const std::vector<PlacePair>& pairs,
                                            const std::vector<std::size_t>& labels,
                                            const BootstrapOptions& options) {
  const std::vector<std::size_t> clusters = dense_labels(labels);
  const std::size_t n_clusters = count_clusters(clusters);
  std::vector<double> gained(n_clusters, 0.0);
  std::vector<double> counts(n_clusters, 0.0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    gained[clusters[i]] += (pairs[i].fits ? 1.0 : 0.0) - (pairs[i].fits_elsewhere ? 1.0 : 0.0);
    counts[clusters[i]] += 1.0;
  }
  const auto mean_gain = [&](std::span<const std::size_t> drawn) {
    double sum = 0.0;
    double n = 0.0;
    for (const std::size_t cluster : drawn) {
      sum += gained[cluster];
      n += counts[cluster];
    }
    return sum / n;
  };
  return clustered_bootstrap(n_clusters, mean_gain, options);
}

}  // namespace

bool CloudFollowing::is_known() const {
  constexpr std::size_t kMinPairs = 30;
  return n_pairs >= kMinPairs && n_clusters >= kMinClusters && ci95.has_value();
}

bool CloudFollowing::is_of_another_place() const {
  constexpr double kSmallDifference = 0.15;
  return is_known() && ci95->low <= 0.0 && ci95->high < kSmallDifference;
}

bool CloudFollowing::is_weak() const {
  constexpr double kClearDifference = 0.3;
  return is_known() && difference() < kClearDifference;
}

CloudFollowing cloud_following(std::span<const JudgedLine> lines,
                               std::span<const LineEvaluation> evaluations,
                               std::span<const JudgedDecoy> elsewhere,
                               const Eigen::Vector3d& shift_m,
                               const BootstrapOptions& options) {
  check(lines.size() == evaluations.size(), "cloud_following: ", lines.size(), " lines, but ",
        evaluations.size(), " evaluations");
  const std::vector<std::size_t> clusters = cluster_labels(evaluations);
  std::vector<PlacePair> pairs;
  std::vector<std::size_t> labels;
  CloudFollowing result;
  double n_fit = 0.0;
  double n_fit_elsewhere = 0.0;
  for (const JudgedDecoy& moved : elsewhere) {
    const std::size_t parent = moved.decoy.parent;
    check(parent < lines.size(), "cloud_following: line ", parent, " of ", lines.size(),
          " was moved, must be one of them");
    const auto pair = pair_of(lines[parent].segment, evaluations[parent], moved, shift_m);
    if (!pair) continue;
    pairs.push_back(*pair);
    labels.push_back(clusters[parent]);
    n_fit += pair->fits ? 1.0 : 0.0;
    n_fit_elsewhere += pair->fits_elsewhere ? 1.0 : 0.0;
  }
  result.n_pairs = pairs.size();
  if (pairs.empty()) return result;
  result.n_clusters = count_clusters(labels);
  result.share = n_fit / static_cast<double>(pairs.size());
  result.share_elsewhere = n_fit_elsewhere / static_cast<double>(pairs.size());
  result.ci95 = difference_interval(pairs, labels, options);
  return result;
}

}  // namespace ridgeline::evaluate
