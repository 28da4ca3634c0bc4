// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/bootstrap.h"

#include "evaluate/probability.h"
#include "evaluate/statistics/distribution.h"
#include "evaluate/statistics/random.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/disjoint_sets.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/geometry/transformed.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <numeric>
#include <string>
#include <unordered_map>

namespace ridgeline::evaluate {
namespace {

std::vector<double> replicate_values(std::size_t n_clusters,
                                     const ClusterStatistic& statistic,
                                     const BootstrapOptions& options) {
  std::vector<double> values(static_cast<std::size_t>(options.replicates));
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t replicate) {
    Interruption::check();
    KeyedRandom random(options.seed, replicate);
    std::vector<std::size_t> drawn(n_clusters);
    for (std::size_t& cluster : drawn) cluster = random.below(n_clusters);
    values[replicate] = statistic(drawn);
  });
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  return values;
}

/// Acceleration from the jackknife over clusters (Efron 1987, eq. 6.6); 0 if the jackknife values
/// have no spread.
double acceleration(std::size_t n_clusters, const ClusterStatistic& statistic) {
  std::vector<double> left_out(n_clusters);
  for (std::size_t out = 0; out < n_clusters; ++out) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < n_clusters; ++i) {
      if (i != out) kept.push_back(i);
    }
    left_out[out] = statistic(kept);
  }
  const double mean = sum(left_out) / static_cast<double>(n_clusters);
  double squares = 0.0;
  double cubes = 0.0;
  for (const double v : left_out) {
    squares += (mean - v) * (mean - v);
    cubes += (mean - v) * (mean - v) * (mean - v);
  }
  const double a = cubes / (6.0 * std::pow(squares, 1.5));
  return std::isfinite(a) ? a : 0.0;
}

/// The shares of the replicates between which the BCa interval lies, for the plain shares (1 -+
/// level) / 2.
Interval bca_shares(std::span<const double> values,
                    std::size_t n_clusters,
                    const ClusterStatistic& statistic,
                    double level) {
  std::vector<std::size_t> all(n_clusters);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const double estimate = statistic(all);
  // Ties count half, and the share is kept away from 0 and 1, where the normal quantile is
  // infinite.
  double below = 0.5;
  for (const double v : values) below += v < estimate ? 1.0 : (v == estimate ? 0.5 : 0.0);
  const double z0 = normal_quantile(below / (static_cast<double>(values.size()) + 1.0));
  const double a = acceleration(n_clusters, statistic);
  const auto share = [&](double plain) {
    const double z = z0 + normal_quantile(plain);
    return normal_cdf(z0 + z / (1.0 - a * z));
  };
  return {share(0.5 * (1.0 - level)), share(0.5 * (1.0 + level))};
}

}  // namespace

std::vector<std::size_t> dense_labels(std::span<const std::size_t> labels) {
  std::unordered_map<std::size_t, std::size_t> dense;
  return transformed(labels, [&](const std::size_t label) {
    return dense.try_emplace(label, dense.size()).first->second;
  });
}

std::size_t count_clusters(std::span<const std::size_t> labels) {
  const std::vector<std::size_t> dense = dense_labels(labels);
  return dense.empty() ? 0 : *std::max_element(dense.begin(), dense.end()) + 1;
}

std::vector<std::size_t> cluster_labels(std::span<const LineEvaluation> lines) {
  DisjointSets sets(lines.size());
  std::map<std::string, std::size_t> first_of_building;
  std::map<std::uint64_t, std::size_t> first_of_plane;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].building.empty()) {
      sets.join(i, first_of_building.try_emplace(lines[i].building, i).first->second);
      continue;
    }
    for (const JudgingPlane& plane : lines[i].planes) {
      if (plane.id == 0) continue;
      sets.join(i, first_of_plane.try_emplace(plane.id, i).first->second);
    }
  }
  std::vector<std::size_t> roots(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) roots[i] = sets.name_of(i);
  return dense_labels(roots);
}

std::optional<Interval> clustered_bootstrap(std::size_t n_clusters,
                                            const ClusterStatistic& statistic,
                                            const BootstrapOptions& options) {
  check(options.replicates >= 1, "replicates = ", options.replicates, ", must be >= 1");
  check(options.level > 0.0 && options.level < 1.0, "level = ", options.level,
        ", must be in (0, 1)");
  if (n_clusters < 2) return std::nullopt;
  std::vector<double> values = replicate_values(n_clusters, statistic, options);
  if (values.empty()) return std::nullopt;
  const Interval shares = options.bca
                              ? bca_shares(values, n_clusters, statistic, options.level)
                              : Interval{0.5 * (1.0 - options.level), 0.5 * (1.0 + options.level)};
  return Interval{*quantile(values, shares.low), *quantile(values, shares.high)};
}

std::optional<Interval> bootstrap_rms(std::span<const double> errors,
                                      std::span<const std::size_t> clusters,
                                      const BootstrapOptions& options) {
  check(errors.size() == clusters.size(), "bootstrap_rms: ", errors.size(), " errors, but ",
        clusters.size(), " cluster labels");
  const std::vector<std::size_t> dense = dense_labels(clusters);
  const std::size_t n_clusters = count_clusters(dense);
  struct ErrorCluster {
    double n = 0.0, squares = 0.0;
    auto operator<=>(const ErrorCluster&) const = default;
  };
  std::vector<ErrorCluster> sums(n_clusters);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    sums[dense[i]].n += 1.0;
    sums[dense[i]].squares += errors[i] * errors[i];
  }
  std::ranges::sort(sums);  // the interval must not depend on the order of the lines
  const auto rms = [&](std::span<const std::size_t> drawn) {
    double sum_squares = 0.0;
    double n = 0.0;
    for (const std::size_t cluster : drawn) {
      sum_squares += sums[cluster].squares;
      n += sums[cluster].n;
    }
    return std::sqrt(sum_squares / n);
  };
  return clustered_bootstrap(n_clusters, rms, options);
}

}  // namespace ridgeline::evaluate
