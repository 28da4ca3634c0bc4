// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/completeness.h"
#include "evaluate/statistics/summary.h"
#include "evaluate/tables/table1.h"

#include <optional>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

/// The unit of a figure, which determines its possible limits and allowances.
enum class MetricUnit : std::uint8_t { kMetres, kShare };

/// A figure that a gate can check.
struct Metric {
  std::string_view name;
  std::string_view meaning;  ///< a few words, for the list of metrics
  MetricUnit unit;
  bool is_signed = false;  ///< a one-sided limit says little, a ratio between classes nothing
};

/// Figures of a class of Table 2: rms_m, q95_m, evaluated_share, ...
std::vector<Metric> accuracy_metrics();

/// Figures of Table 1: correctness, completeness, quality.
std::vector<Metric> matching_metrics();

/// Figures of tracks: edge_recall, observation_recall, observation_precision.
std::vector<Metric> track_metrics();

/// Figures of the buildings named by the lines: buildings_within_m.
std::vector<Metric> building_metrics();

/// Figures of decoys: decoy_share.
std::vector<Metric> decoy_metrics();

/// Figures of the edges of the scan: scan_recall, scan_recall_length.
std::vector<Metric> scan_metrics();

/// A metric of any kind by its name; empty for an unknown name.
std::optional<Metric> find_metric(std::string_view name);
bool is_matching_metric(std::string_view name);
bool is_track_metric(std::string_view name);
bool is_building_metric(std::string_view name);
bool is_decoy_metric(std::string_view name);
bool is_scan_metric(std::string_view name);
/// Whether the figure has an interval from a bootstrap over clusters that a gate may limit.
bool has_clustered_interval(std::string_view name);

/// The value of a metric for a class; empty if the class does not have it.
/// Throws std::invalid_argument for a name that is not in accuracy_metrics().
std::optional<double> metric_value(const Summary& summary, std::string_view metric);

/// The value of a matching metric; empty if its denominator is 0.
/// Throws std::invalid_argument for a name that is not in matching_metrics().
std::optional<double> metric_value(const MatchCounts& counts, std::string_view metric);

/// The value of a track metric, and its denominator. Both throw as above.
std::optional<double> metric_value(const TrackCounts& counts, std::string_view metric);
std::size_t metric_count(const TrackCounts& counts, std::string_view metric);

/// The value of a metric of the scan's edges. Throws as above.
std::optional<double> metric_value(const CompletenessRow& row, std::string_view metric);

/// The 95 % interval of a figure; empty if the figure has none. Throws like metric_value().
std::optional<Interval> metric_interval(const Summary& summary, std::string_view metric);
std::optional<Interval> metric_interval(const MatchCounts& counts, std::string_view metric);
std::optional<Interval> metric_interval(const CompletenessRow& row, std::string_view metric);

/// Number of lines on which a figure is based: all lines for evaluated_share and
/// evaluated_share_by_length, the ridges and hips for horizontal and vertical components, else the
/// evaluated lines.
std::size_t metric_count(const Summary& summary, std::string_view metric);

/// Number of matches on which a figure is based, i.e. its denominator. Throws like metric_value().
std::size_t metric_count(const MatchCounts& counts, std::string_view metric);

}  // namespace ridgeline::evaluate
