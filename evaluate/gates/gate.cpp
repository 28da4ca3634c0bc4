// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/gates/gate.h"

#include "evaluate/gates/figure.h"
#include "evaluate/gates/gate_warnings.h"
#include "evaluate/gates/metric.h"
#include "evaluate/statistics/completeness.h"
#include "evaluate/statistics/image_count.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

Metric metric_of(const Gate& gate) {
  const std::optional<Metric> metric = find_metric(gate.metric);
  std::vector<std::string_view> known;
  for (const Metric& m : accuracy_metrics()) known.push_back(m.name);
  for (const Metric& m : matching_metrics()) known.push_back(m.name);
  for (const Metric& m : track_metrics()) known.push_back(m.name);
  for (const Metric& m : building_metrics()) known.push_back(m.name);
  for (const Metric& m : decoy_metrics()) known.push_back(m.name);
  for (const Metric& m : scan_metrics()) known.push_back(m.name);
  check(metric.has_value(), "metric: ", gate.metric, "; must be one of ",
        fmt::format("{}", fmt::join(known, ", ")));
  return *metric;
}

void check_limit(const char* rule, std::optional<double> limit, const Metric& metric) {
  if (!limit) return;
  check(std::isfinite(*limit), rule, ": ", *limit, "; must be finite");
  const bool is_share = metric.unit == MetricUnit::kShare;
  check(!is_share || (*limit >= 0.0 && *limit <= 1.0), rule, ": ", *limit, "; ", metric.name,
        " is a share, so it must be 0 to 1");
}

void check_allowances(const Gate& gate, const Metric& metric) {
  const auto check_allowance = [](const char* rule, double allowance) {
    check(std::isfinite(allowance) && allowance >= 0.0, rule, ": ", allowance, "; must be >= 0");
  };
  if (gate.max_increase_over_baseline) {
    const std::optional<double>& value = gate.max_increase_over_baseline->value;
    check(value || metric.unit == MetricUnit::kMetres,
          "max_increase_over_baseline: default; only for figures in metres, but ", metric.name,
          " is a share, so it must be a number");
    check_allowance("max_increase_over_baseline", value.value_or(0.0));
  }
  check_allowance("max_decrease_below_baseline", gate.max_decrease_below_baseline.value_or(0.0));
}

/// Throws for a selector of lines in a gate on a figure of all lines.
void refuse_selectors(const Gate& gate) {
  check(gate.line_class == kTotal, "class: ", gate.line_class, "; ", gate.metric,
        " covers all classes, so class must be omitted");
  check(!gate.n_images, "n_images: ", gate.n_images.value_or(0), "; ", gate.metric,
        " covers lines of any number of images, so n_images must be omitted");
  check(!gate.decided_by, "decided_by: ", gate.metric,
        " covers all judged lines, so decided_by must be omitted");
  check(!gate.max_ratio_to_class, "max_ratio_to: ", gate.metric, " has no classes to compare");
}

void check_scan(const Gate& gate) {
  check(!gate.distance_m, "distance_m: ", gate.metric, " does not use it; only decoy_share does");
  check(!gate.kind || std::ranges::find(kEdgeKinds, *gate.kind) != kEdgeKinds.end(),
        "kind: ", gate.kind.value_or(""), "; ", gate.metric, " requires one of ",
        fmt::format("{}", fmt::join(kEdgeKinds, ", ")));
  refuse_selectors(gate);
}

void check_kind(const Gate& gate) {
  if (is_scan_metric(gate.metric)) return check_scan(gate);
  if (!is_decoy_metric(gate.metric)) {
    check(!gate.kind && !gate.distance_m, gate.kind ? "kind: " : "distance_m: ", gate.metric,
          " does not use it; only decoy_share ", gate.kind ? "and scan_recall do" : "does");
    return;
  }
  const auto is_kind = [&](DecoyKind kind) { return name(kind) == gate.kind; };
  check(std::ranges::any_of(kDecoyKinds, is_kind), "kind: ", gate.kind.value_or("none"),
        "; decoy_share requires height, across or match");
  const auto is_distance = [&](double distance_m) { return distance_m == gate.distance_m; };
  check(std::ranges::any_of(kDecoyDistances_m, is_distance),
        "distance_m: ", gate.distance_m ? fmt::format("{}", *gate.distance_m) : "none",
        "; decoy_share requires one of ", fmt::format("{}", fmt::join(kDecoyDistances_m, ", ")));
  refuse_selectors(gate);
}

/// An upper limit is meaningless for a figure that must not fall, and intervals of other figures
/// are not available here.
void check_bound(const Gate& gate) {
  if (gate.bound == GateBound::kPoint) return;
  check(has_clustered_interval(gate.metric), "bound: upper95; ", gate.metric,
        " has no clustered interval to limit; only rms_m and decoy_share have");
  const auto refuse = [](const char* rule, bool is_given) {
    check(!is_given, "bound: upper95; only for max, so ", rule, " needs its own entry");
  };
  refuse("min", gate.min.has_value());
  refuse("max_ratio_to", gate.max_ratio_to_class.has_value());
  refuse("max_increase_over_baseline", gate.max_increase_over_baseline.has_value());
  refuse("max_decrease_below_baseline", gate.max_decrease_below_baseline.has_value());
}

void check_same_inputs(const ResultFolder& results, const ResultFolder& baseline) {
  check(!baseline.input_hashes.empty() && !results.input_hashes.empty(), "baseline ", baseline.name,
        ": has no input hashes, which are needed to compare the inputs");
  for (const auto& input : results.input_hashes) {
    const std::string& file = input.first;
    const bool has_name =
        std::any_of(baseline.input_hashes.begin(), baseline.input_hashes.end(),
                    [&](const auto& of_baseline) { return of_baseline.first == file; });
    check(baseline.input_hashes.contains(input), "baseline ", baseline.name, ": the input ", file,
          has_name ? " differs" : " is not one of its inputs",
          "; a baseline must have the same inputs");
  }
  check(baseline.input_hashes.size() == results.input_hashes.size(), "baseline ", baseline.name,
        ": it has inputs missing here; a baseline must have the same inputs");
}

/// The figure of the same cell in the baseline. If the baseline has none, the result has a reason
/// instead of a value.
Figure baseline_figure(const Gate& gate, const Figure& figure, const ResultFolder* baseline) {
  Figure none;
  none.why_missing = "no baseline is given (`baseline`)";
  if (baseline == nullptr) return none;
  Gate same_cell = gate;
  same_cell.patch = figure.patch;
  if (!is_track_metric(gate.metric)) same_cell.method = figure.method;
  Figure found = figures_of(same_cell, gate.line_class, *baseline).front();
  if (!found.value) found.why_missing = "the baseline has no such figure: " + found.why_missing;
  return found;
}

/// A result without a verdict, filled from the figure. `rule`: the requirement, e.g. "<= 0.3".
GateResult begin_result(const Gate& gate, const Figure& figure, const std::string& rule) {
  GateResult result;
  const std::string of_images =
      gate.n_images ? fmt::format(" of {} images", image_group_name(*image_group(gate.n_images)))
                    : "";
  const std::string decided_by =
      gate.decided_by ? fmt::format(" decided by {}", name(*gate.decided_by)) : "";
  const std::string within = gate.within_m ? fmt::format(" {}", *gate.within_m) : "";
  const std::string of_kind = gate.kind ? fmt::format(" {}", *gate.kind) : "";
  const std::string moved = gate.distance_m ? fmt::format(" {} m", *gate.distance_m) : "";
  const std::string bound =
      gate.bound == GateBound::kPoint ? "" : fmt::format(" {}", name(gate.bound));
  result.rule =
      fmt::format("{}{}{}{}{}{}{}{}{} {}", figure.line_class, figure.line_class.empty() ? "" : " ",
                  gate.metric, within, of_kind, moved, of_images, decided_by, bound, rule);
  if (gate.n_min) result.rule += fmt::format(" (n >= {})", *gate.n_min);
  result.patch = figure.patch;
  result.method = figure.method;
  result.line_class = figure.line_class;
  result.metric = gate.metric;
  result.n_images = gate.n_images;
  result.decided_by = gate.decided_by;
  result.value = figure.value;
  result.ci95 = figure.ci95;
  result.bound = gate.bound;
  result.n_clusters = figure.n_clusters;
  result.n = figure.n;
  result.evaluated_share = figure.evaluated_share;
  result.explanation = figure.why_missing;
  return result;
}

enum class Bound : std::uint8_t { kUpper, kLower };

/// Why the figure is too uncertain for a verdict; "" if it is not.
std::string why_insufficient(const GateResult& result, const Gate& gate) {
  if (gate.n_min && result.n < *gate.n_min) {
    return fmt::format("n = {}, at least {} required", result.n, *gate.n_min);
  }
  const bool needs_interval = gate.bound == GateBound::kUpper95 || is_decoy_metric(gate.metric);
  if (!needs_interval) return "";
  if (!result.ci95) return "there is no 95 % interval: too few clusters";
  if (gate.bound == GateBound::kUpper95 && result.n_clusters < kMinClusters) {
    return fmt::format("the interval has {} clusters, at least {} required", result.n_clusters,
                       kMinClusters);
  }
  const double width = result.ci95->high - result.ci95->low;
  if (is_decoy_metric(gate.metric) && width > *result.limit) {
    return fmt::format("the 95 % interval, {:.4g} to {:.4g}, is wider than the limit {:.4g}",
                       result.ci95->low, result.ci95->high, *result.limit);
  }
  return "";
}

/// Sets the verdict from value and limit. NaN fails. An existing explanation gives the reason for a
/// missing value or limit.
GateResult settle(GateResult result, const Gate& gate, Bound bound) {
  if (!result.value || !result.limit) {
    result.verdict = Verdict::kMissing;
    return result;
  }
  if (std::string why = why_insufficient(result, gate); !why.empty()) {
    result.verdict = Verdict::kInsufficient;
    result.explanation = std::move(why);
    return result;
  }
  const bool by_interval = gate.bound == GateBound::kUpper95;
  const double value = by_interval ? result.ci95->high : *result.value;
  const bool holds = bound == Bound::kUpper ? value <= *result.limit : value >= *result.limit;
  result.verdict = holds ? Verdict::kPassed : Verdict::kFailed;
  if (!holds) {
    result.explanation = fmt::format("{}{:.4g} is {} the limit {:.4g}",
                                     by_interval ? "upper end of the 95 % interval: " : "", value,
                                     bound == Bound::kUpper ? "above" : "below", *result.limit);
  }
  return result;
}

GateResult apply_limit(const Gate& gate, const Figure& figure, double limit, Bound bound) {
  GateResult result =
      begin_result(gate, figure, fmt::format("{} {}", bound == Bound::kUpper ? "<=" : ">=", limit));
  result.limit = limit;
  return settle(std::move(result), gate, bound);
}

GateResult apply_ratio(const Gate& gate, const Figure& figure, const ResultFolder& folder) {
  const std::string& other_class = *gate.max_ratio_to_class;
  GateResult result =
      begin_result(gate, figure, fmt::format("<= {} x {}", gate.ratio, other_class));
  for (const Figure& other : figures_of(gate, other_class, folder)) {
    if (other.patch != figure.patch || other.method != figure.method) continue;
    if (other.value) result.limit = gate.ratio * *other.value;
    result.n = std::min(figure.n, other.n);
    if (result.explanation.empty()) result.explanation = other.why_missing;
  }
  return settle(std::move(result), gate, Bound::kUpper);
}

/// `allowance`: permitted deviation from the baseline; if empty, the default of BaselineIncrease.
GateResult apply_baseline(const Gate& gate,
                          const Figure& figure,
                          const ResultFolder* baseline,
                          std::optional<double> allowance,
                          Bound bound) {
  constexpr double kMinIncrease_m = 0.002;
  constexpr double kIncreaseShare = 0.05;
  const Figure base = baseline_figure(gate, figure, baseline);
  const double a = allowance.value_or(
      std::max(kMinIncrease_m, kIncreaseShare * std::abs(base.value.value_or(0.0))));
  const bool upper = bound == Bound::kUpper;
  // the name of a check must not depend on the baseline
  const std::string allowed =
      allowance ? fmt::format("{:.4g}", a)
                : fmt::format("max({}, {:.0f} %)", kMinIncrease_m, 100.0 * kIncreaseShare);
  GateResult result = begin_result(
      gate, figure,
      fmt::format("{} baseline {} {}", upper ? "<=" : ">=", upper ? '+' : '-', allowed));
  result.baseline = base.value;
  if (result.explanation.empty()) result.explanation = base.why_missing;
  if (base.value) {
    result.limit = *base.value + (upper ? a : -a);
    result.baseline_can_be_tightened =
        result.value && (upper ? *result.value < *base.value - a : *result.value > *base.value + a);
  }
  return settle(std::move(result), gate, bound);
}

void apply_to_figure(const Gate& gate,
                     const Figure& figure,
                     const ResultFolder& folder,
                     const ResultFolder* baseline,
                     std::vector<GateResult>& results) {
  if (gate.max) results.push_back(apply_limit(gate, figure, *gate.max, Bound::kUpper));
  if (gate.min) results.push_back(apply_limit(gate, figure, *gate.min, Bound::kLower));
  if (gate.max_ratio_to_class) results.push_back(apply_ratio(gate, figure, folder));
  if (gate.max_increase_over_baseline) {
    results.push_back(apply_baseline(gate, figure, baseline, gate.max_increase_over_baseline->value,
                                     Bound::kUpper));
  }
  if (gate.max_decrease_below_baseline) {
    results.push_back(
        apply_baseline(gate, figure, baseline, gate.max_decrease_below_baseline, Bound::kLower));
  }
}

}  // namespace

void validate(const Gate& gate) {
  const Metric metric = metric_of(gate);
  check(gate.max || gate.min || gate.max_ratio_to_class || gate.max_increase_over_baseline ||
            gate.max_decrease_below_baseline,
        "a gate on ", gate.metric,
        " has no rule; it requires max, min, max_ratio_to, max_increase_over_baseline or "
        "max_decrease_below_baseline");
  const bool of_matching = is_matching_metric(gate.metric);
  check(!of_matching || gate.line_class == kTotal, "class: ", gate.line_class, "; ", gate.metric,
        " measures matching, which has no classes, so class must be omitted");
  check(!gate.n_images || !of_matching, "n_images: ", gate.n_images.value_or(0), "; ", gate.metric,
        " measures the matches of two images, so n_images must be omitted");
  check(!gate.n_images || (*gate.n_images >= kMinImages && *gate.n_images <= kMaxImages),
        "n_images: ", gate.n_images.value_or(0), "; must be ", kMinImages, " to ", kMaxImages, "; ",
        kMaxImages, " means ", kMaxImages, " and more");
  check(!gate.decided_by || !(of_matching || is_track_metric(gate.metric)),
        "decided_by: ", gate.metric,
        " does not measure judged lines, so decided_by must be omitted");
  const bool of_buildings = is_building_metric(gate.metric);
  check(of_buildings == gate.within_m.has_value(), "within_m: ", gate.metric,
        of_buildings ? " requires it: the largest acceptable RMS of a building's lines"
                     : " does not use it; only buildings_within_m does");
  check(!gate.within_m || *gate.within_m >= 0.0, "within_m: ", gate.within_m.value_or(0.0),
        "; must be >= 0");
  check(!gate.max_ratio_to_class || !of_matching, "max_ratio_to: ", gate.metric,
        " measures matching, which has no classes to compare");
  check(!gate.max_ratio_to_class || !metric.is_signed, "max_ratio_to: ", gate.metric,
        " is signed, so a ratio is meaningless; use min and max");
  check_limit("max", gate.max, metric);
  check_limit("min", gate.min, metric);
  check(std::isfinite(gate.ratio) && gate.ratio > 0.0, "ratio: ", gate.ratio, "; must be > 0");
  check_allowances(gate, metric);
  check_kind(gate);
  check_bound(gate);
}

const char* name(GateBound bound) { return bound == GateBound::kUpper95 ? "upper95" : "point"; }

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPassed:
      return "passed";
    case Verdict::kFailed:
      return "failed";
    case Verdict::kInsufficient:
      return "insufficient";
    case Verdict::kMissing:
      return "missing";
  }
  return "unknown";
}

bool GateReport::passed() const {
  return !results.empty() && std::all_of(results.begin(), results.end(), [](const GateResult& r) {
    return r.verdict == Verdict::kPassed;
  });
}

GateReport apply_gates(std::span<const Gate> gates,
                       const ResultFolder& results,
                       const ResultFolder* baseline) {
  for (const Gate& gate : gates) validate(gate);
  if (baseline != nullptr) check_same_inputs(results, *baseline);
  GateReport report;
  for (const Gate& gate : gates) {
    for (const Figure& figure : figures_of(gate, gate.line_class, results)) {
      apply_to_figure(gate, figure, results, baseline, report.results);
    }
  }
  report.warnings = gate_warnings(gates, report.results, results, baseline);
  return report;
}

}  // namespace ridgeline::evaluate
