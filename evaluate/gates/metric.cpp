// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/gates/metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using FigureOf = std::optional<double> (*)(const Summary&);

struct AccuracyMetric {
  std::string_view name;
  FigureOf figure;
};

constexpr std::array kAccuracyMetrics{
    AccuracyMetric{"rms_m", [](const Summary& s) { return s.rms_m; }},
    AccuracyMetric{"rms_length_weighted_m",
                   [](const Summary& s) { return s.rms_length_weighted_m; }},
    AccuracyMetric{"mean_m", [](const Summary& s) { return s.mean_m; }},
    AccuracyMetric{"std_m", [](const Summary& s) { return s.std_m; }},
    AccuracyMetric{"median_m", [](const Summary& s) { return s.median_m; }},
    AccuracyMetric{"nmad_m", [](const Summary& s) { return s.nmad_m; }},
    AccuracyMetric{"q683_m", [](const Summary& s) { return s.q683_m; }},
    AccuracyMetric{"q90_m", [](const Summary& s) { return s.q90_m; }},
    AccuracyMetric{"q95_m", [](const Summary& s) { return s.q95_m; }},
    AccuracyMetric{"max_m", [](const Summary& s) { return s.max_m; }},
    AccuracyMetric{"gross_share", [](const Summary& s) { return s.gross_share; }},
    AccuracyMetric{"evaluated_share", [](const Summary& s) { return s.evaluated_share(); }},
    AccuracyMetric{"evaluated_share_by_length",
                   [](const Summary& s) { return s.evaluated_share_by_length(); }},
};

struct MatchingMetric {
  std::string_view name;
  std::optional<double> MatchQuality::*figure;
};

constexpr std::array kMatchingMetrics{MatchingMetric{"correctness", &MatchQuality::correctness},
                                      MatchingMetric{"completeness", &MatchQuality::completeness},
                                      MatchingMetric{"quality", &MatchQuality::quality}};

template <typename Metrics>
std::vector<std::string_view> names(const Metrics& metrics) {
  std::vector<std::string_view> result;
  result.reserve(metrics.size());
  for (const auto& m : metrics) result.push_back(m.name);
  return result;
}

template <typename Metrics>
auto find(const Metrics& metrics, std::string_view metric) {
  return std::find_if(metrics.begin(), metrics.end(),
                      [&](const auto& m) { return m.name == metric; });
}

[[noreturn]] void reject(std::string_view metric, const std::vector<std::string_view>& known) {
  throw std::invalid_argument(
      fmt::format("metric: {}; must be one of {}", metric, fmt::join(known, ", ")));
}

}  // namespace

std::vector<std::string_view> accuracy_metrics() { return names(kAccuracyMetrics); }
std::vector<std::string_view> matching_metrics() { return names(kMatchingMetrics); }

bool is_accuracy_metric(std::string_view metric) {
  return find(kAccuracyMetrics, metric) != kAccuracyMetrics.end();
}

bool is_matching_metric(std::string_view metric) {
  return find(kMatchingMetrics, metric) != kMatchingMetrics.end();
}

std::optional<double> metric_value(const Summary& summary, std::string_view metric) {
  if (!is_accuracy_metric(metric)) reject(metric, accuracy_metrics());
  return find(kAccuracyMetrics, metric)->figure(summary);
}

std::optional<double> metric_value(const MatchCounts& counts, std::string_view metric) {
  if (!is_matching_metric(metric)) reject(metric, matching_metrics());
  return match_quality(counts).*(find(kMatchingMetrics, metric)->figure);
}

std::size_t metric_count(const Summary& summary, std::string_view metric) {
  return metric.starts_with("evaluated_share") ? summary.n_lines : summary.n_evaluated;
}

}  // namespace ridgeline::evaluate
