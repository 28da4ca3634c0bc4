// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/gates/metric.h"

#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

constexpr MetricUnit kInMetres = MetricUnit::kMetres;
constexpr MetricUnit kAsShare = MetricUnit::kShare;
constexpr bool kIsSigned = true;
constexpr std::string_view kRmsMetric = "rms_m";

struct AccuracyMetric {
  Metric metric;
  std::optional<double> (*figure)(const Summary&);
};

constexpr std::array kAccuracyMetrics{
    AccuracyMetric{{kRmsMetric, "RMS of the lines' mean distances to their planes", kInMetres},
                   [](const Summary& s) { return s.rms_m; }},
    AccuracyMetric{{"rms_length_weighted_m", "the same, weighted by length", kInMetres},
                   [](const Summary& s) { return s.rms_length_weighted_m; }},
    AccuracyMetric{
        {"mean_m", "bias: mean of the signed distances; use min and max", kInMetres, kIsSigned},
        [](const Summary& s) { return s.mean_m; }},
    AccuracyMetric{{"std_m", "standard deviation of the signed distances", kInMetres},
                   [](const Summary& s) { return s.std_m; }},
    AccuracyMetric{{"median_m", "median of the mean distances", kInMetres},
                   [](const Summary& s) { return s.median_m; }},
    AccuracyMetric{
        {"nmad_m", "1.4826 x median absolute deviation of the signed distances", kInMetres},
        [](const Summary& s) { return s.nmad_m; }},
    AccuracyMetric{{"q683_m", "68.3 % quantile of the distances", kInMetres},
                   [](const Summary& s) { return s.q683_m; }},
    AccuracyMetric{{"q90_m", "90 % quantile of the distances", kInMetres},
                   [](const Summary& s) { return s.q90_m; }},
    AccuracyMetric{{"q95_m", "95 % quantile of the distances", kInMetres},
                   [](const Summary& s) { return s.q95_m; }},
    AccuracyMetric{{"max_m", "largest distance", kInMetres},
                   [](const Summary& s) { return s.max_m; }},
    AccuracyMetric{{"gross_share", "share of the lines farther off than gross_m", kAsShare},
                   [](const Summary& s) { return s.gross_share; }},
    AccuracyMetric{{"evaluated_share", "share of the lines that could be judged", kAsShare},
                   [](const Summary& s) { return s.evaluated_share(); }},
    AccuracyMetric{{"evaluated_share_by_length", "the same, weighted by length", kAsShare},
                   [](const Summary& s) { return s.evaluated_share_by_length(); }},
    AccuracyMetric{{"rmse_horizontal_m", "RMSE across ridges and hips in plan", kInMetres},
                   [](const Summary& s) { return s.rmse_horizontal_m; }},
    AccuracyMetric{{"rmse_vertical_m", "RMSE in height of ridges and hips", kInMetres},
                   [](const Summary& s) { return s.rmse_vertical_m; }},
    AccuracyMetric{{"mean_vertical_m", "mean of the same; use min and max", kInMetres, kIsSigned},
                   [](const Summary& s) { return s.mean_vertical_m; }},
};

struct MatchingMetric {
  Metric metric;
  std::optional<double> MatchQuality::*figure;
  std::optional<Interval> MatchQuality::*interval;
  std::size_t (*count)(const MatchCounts&);
};

constexpr std::array kMatchingMetrics{
    MatchingMetric{{"correctness", "correct matches / (correct + false)", kAsShare},
                   &MatchQuality::correctness,
                   &MatchQuality::correctness_ci95,
                   [](const MatchCounts& c) { return c.n_correct + c.n_false; }},
    MatchingMetric{{"completeness", "correct matches / (correct + missed)", kAsShare},
                   &MatchQuality::completeness,
                   &MatchQuality::completeness_ci95,
                   [](const MatchCounts& c) { return c.n_correct + c.n_missed; }},
    MatchingMetric{{"quality", "correct matches / (correct + false + missed)", kAsShare},
                   &MatchQuality::quality,
                   &MatchQuality::quality_ci95,
                   [](const MatchCounts& c) { return c.n_correct + c.n_false + c.n_missed; }}};

struct TrackMetric {
  Metric metric;
  std::optional<double> (*figure)(const TrackCounts&);
  std::size_t (*count)(const TrackCounts&);
};

constexpr std::array kTrackMetrics{
    TrackMetric{
        {"edge_recall", "true edges found by a track / all visible in two images", kAsShare},
        [](const TrackCounts& c) { return c.edge_recall(); },
        [](const TrackCounts& c) { return c.n_edges; }},
    TrackMetric{{"observation_recall", "their images in these tracks / all images that show them",
                 kAsShare},
                [](const TrackCounts& c) { return c.observation_recall(); },
                [](const TrackCounts& c) { return c.n_shown; }},
    TrackMetric{{"observation_precision", "correct observations / (correct + wrong)", kAsShare},
                [](const TrackCounts& c) { return c.observation_precision(); },
                [](const TrackCounts& c) { return c.n_right + c.n_wrong; }}};

struct BuildingMetric {
  Metric metric;
};

constexpr std::array kBuildingMetrics{BuildingMetric{
    {"buildings_within_m", "share of the buildings whose lines have an RMS of at most within_m",
     kAsShare}}};

struct DecoyMetric {
  Metric metric;
};

constexpr std::array kDecoyMetrics{
    DecoyMetric{{"decoy_share",
                 "share of the lines moved by distance_m that still pass within 0.2 m", kAsShare}}};

struct ScanMetric {
  Metric metric;
  std::optional<double> (*figure)(const CompletenessRow&);
};

constexpr std::array kScanMetrics{
    ScanMetric{{"scan_recall", "share of the scan's edges that the lines have found", kAsShare},
               [](const CompletenessRow& row) { return row.recall(); }},
    ScanMetric{{"scan_recall_length", "share of their length that has lines beside it", kAsShare},
               [](const CompletenessRow& row) { return row.recall_by_length(); }}};

template <typename Entries>
std::vector<Metric> metrics_of(const Entries& entries) {
  return transformed(entries, [&](const auto& entry) { return entry.metric; });
}

/// The entry with a name, or nullptr.
template <typename Entries>
const auto* find_entry(const Entries& entries, std::string_view name) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return entry.metric.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

template <typename Entries>
const auto& entry_of(const Entries& entries, std::string_view name) {
  if (const auto* entry = find_entry(entries, name)) return *entry;
  std::vector<std::string_view> known;
  known.reserve(entries.size());
  for (const auto& entry : entries) known.push_back(entry.metric.name);
  throw std::invalid_argument(
      fmt::format("metric: {}; must be one of {}", name, fmt::join(known, ", ")));
}

}  // namespace

std::vector<Metric> accuracy_metrics() { return metrics_of(kAccuracyMetrics); }
std::vector<Metric> matching_metrics() { return metrics_of(kMatchingMetrics); }

std::vector<Metric> track_metrics() { return metrics_of(kTrackMetrics); }

std::vector<Metric> building_metrics() { return metrics_of(kBuildingMetrics); }

std::vector<Metric> decoy_metrics() { return metrics_of(kDecoyMetrics); }

std::vector<Metric> scan_metrics() { return metrics_of(kScanMetrics); }

std::optional<Metric> find_metric(std::string_view name) {
  if (const auto* entry = find_entry(kAccuracyMetrics, name)) return entry->metric;
  if (const auto* entry = find_entry(kMatchingMetrics, name)) return entry->metric;
  if (const auto* entry = find_entry(kTrackMetrics, name)) return entry->metric;
  if (const auto* entry = find_entry(kBuildingMetrics, name)) return entry->metric;
  if (const auto* entry = find_entry(kDecoyMetrics, name)) return entry->metric;
  if (const auto* entry = find_entry(kScanMetrics, name)) return entry->metric;
  return std::nullopt;
}

bool is_track_metric(std::string_view name) { return find_entry(kTrackMetrics, name) != nullptr; }

bool is_building_metric(std::string_view name) {
  return find_entry(kBuildingMetrics, name) != nullptr;
}

bool is_decoy_metric(std::string_view name) { return find_entry(kDecoyMetrics, name) != nullptr; }

bool is_scan_metric(std::string_view name) { return find_entry(kScanMetrics, name) != nullptr; }

bool has_clustered_interval(std::string_view name) {
  return name == kRmsMetric || is_decoy_metric(name);
}

bool is_matching_metric(std::string_view name) {
  return find_entry(kMatchingMetrics, name) != nullptr;
}

std::optional<double> metric_value(const Summary& summary, std::string_view metric) {
  return entry_of(kAccuracyMetrics, metric).figure(summary);
}

std::optional<double> metric_value(const MatchCounts& counts, std::string_view metric) {
  return match_quality(counts).*(entry_of(kMatchingMetrics, metric).figure);
}

std::optional<double> metric_value(const TrackCounts& counts, std::string_view metric) {
  return entry_of(kTrackMetrics, metric).figure(counts);
}

std::optional<double> metric_value(const CompletenessRow& row, std::string_view metric) {
  return entry_of(kScanMetrics, metric).figure(row);
}

std::optional<Interval> metric_interval(const CompletenessRow& row, std::string_view metric) {
  return metric == kScanMetrics[0].metric.name ? row.ci95 : std::nullopt;
}

std::size_t metric_count(const TrackCounts& counts, std::string_view metric) {
  return entry_of(kTrackMetrics, metric).count(counts);
}

std::optional<Interval> metric_interval(const Summary& summary, std::string_view metric) {
  if (entry_of(kAccuracyMetrics, metric).metric.name != kRmsMetric) return std::nullopt;
  return summary.ci95_m;
}

std::optional<Interval> metric_interval(const MatchCounts& counts, std::string_view metric) {
  return match_quality(counts).*(entry_of(kMatchingMetrics, metric).interval);
}

std::size_t metric_count(const Summary& summary, std::string_view metric) {
  if (metric.starts_with("evaluated_share")) return summary.n_lines;
  const bool is_of_ridges = metric.ends_with("horizontal_m") || metric.ends_with("vertical_m");
  return is_of_ridges ? summary.n_parts : summary.n_evaluated;
}

std::size_t metric_count(const MatchCounts& counts, std::string_view metric) {
  return entry_of(kMatchingMetrics, metric).count(counts);
}

}  // namespace ridgeline::evaluate
