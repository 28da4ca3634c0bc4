// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/interval.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// With fewer clusters than this, an interval is printed together with "too few clusters".
inline constexpr std::size_t kMinClusters = 10;

struct BootstrapOptions {
  int replicates = 2000;         ///< the 2.5 % tail is then based on 50 replicates
  std::uint64_t seed = 1;        ///< recorded with the results
  double level = kDefaultLevel;  ///< of the interval, in (0, 1)
  bool bca = false;  ///< bias-corrected and accelerated (Efron 1987) instead of the percentiles
};

/// Cluster of each line, numbered from 0 in order of first appearance: its building, if set,
/// otherwise the connected component of lines sharing a plane id other than 0. A line with neither
/// is a cluster of its own.
std::vector<std::size_t> cluster_labels(std::span<const LineEvaluation> lines);

/// A statistic of the clusters whose indices are given; an index may occur more than once.
using ClusterStatistic = std::function<double(std::span<const std::size_t> drawn)>;

/// Interval of `statistic` when whole clusters are drawn with replacement. Replicate r uses the
/// generator keyed by (seed, r), so the result is the same for any number of threads; `statistic`
/// is called concurrently. Replicates without a finite value are left out.
/// Empty for fewer than two clusters, because there is nothing to resample.
/// Throws std::invalid_argument for replicates < 1 or a level outside (0, 1).
std::optional<Interval> clustered_bootstrap(std::size_t n_clusters,
                                            const ClusterStatistic& statistic,
                                            const BootstrapOptions& options);

/// Clustered bootstrap of sqrt(sum e^2 / n); `errors[i]` belongs to cluster `clusters[i]`, whose
/// label may have any value. Throws std::invalid_argument for spans of different lengths.
std::optional<Interval> bootstrap_rms(std::span<const double> errors,
                                      std::span<const std::size_t> clusters,
                                      const BootstrapOptions& options);

/// Labels renumbered from 0 without gaps, in order of first appearance.
std::vector<std::size_t> dense_labels(std::span<const std::size_t> labels);

/// Number of distinct labels.
std::size_t count_clusters(std::span<const std::size_t> labels);

}  // namespace ridgeline::evaluate
