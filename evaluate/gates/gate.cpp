// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/gates/gate.h"

#include "evaluate/gates/metric.h"
#include "evaluate/statistics/calibration.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ridgeline::evaluate {
namespace {

/// A figure with what it rests on, from either kind of table.
struct Figure {
  std::string patch, method, line_class;
  std::optional<double> value;
  std::optional<Interval> ci95;
  std::size_t n = 0;
  std::optional<double> evaluated_share;
};

void check_gate(const Gate& gate) {
  check(is_accuracy_metric(gate.metric) || is_matching_metric(gate.metric), "metric: ", gate.metric,
        "; must be one of ",
        fmt::format("{}, {}", fmt::join(accuracy_metrics(), ", "),
                    fmt::join(matching_metrics(), ", ")));
  check(gate.max || gate.min || gate.max_ratio_to_class || gate.max_increase_over_baseline ||
            gate.max_decrease_below_baseline,
        "a gate on ", gate.metric,
        " has no rule; it needs max, min, max_ratio_to or a rule against the baseline");
  check(!gate.max_ratio_to_class || is_accuracy_metric(gate.metric), "max_ratio_to: ", gate.metric,
        " has no classes; it needs a figure of a class");
  const auto check_limit = [](const char* rule, std::optional<double> limit) {
    check(!limit || std::isfinite(*limit), rule, ": ", limit.value_or(0.0), "; must be finite");
  };
  check_limit("max", gate.max);
  check_limit("min", gate.min);
  check(std::isfinite(gate.ratio) && gate.ratio > 0.0, "ratio: ", gate.ratio, "; must be > 0");
  for (const auto& rule : {gate.max_increase_over_baseline, gate.max_decrease_below_baseline}) {
    if (rule) check_limit("allowance over the baseline", rule->value);
    check(!rule || rule->value.value_or(0.0) >= 0.0,
          "allowance over the baseline: ", rule ? rule->value.value_or(0.0) : 0.0,
          "; must be >= 0");
  }
}

void check_same_inputs(const ResultFolder& results, const ResultFolder& baseline) {
  check(!baseline.input_hashes.empty() && !results.input_hashes.empty(), "baseline ", baseline.name,
        ": no input hashes recorded; they must show the same inputs");
  for (const auto& input : results.input_hashes) {
    const std::string& file = input.first;
    const bool has_name =
        std::any_of(baseline.input_hashes.begin(), baseline.input_hashes.end(),
                    [&](const auto& of_baseline) { return of_baseline.first == file; });
    check(baseline.input_hashes.contains(input), "baseline ", baseline.name, ": the input ", file,
          has_name ? " differs" : " is not among its inputs",
          "; a baseline must rest on the same inputs");
  }
  check(baseline.input_hashes.size() == results.input_hashes.size(), "baseline ", baseline.name,
        ": it has inputs that these results do not have; a baseline must rest on the same inputs");
}

bool concerns(const Gate& gate, const std::string& patch, const std::string& method) {
  return gate.patch.value_or(patch) == patch && gate.method.value_or(method) == method;
}

Figure accuracy_figure(const Evaluation& e,
                       const std::string& line_class,
                       const std::string& metric) {
  Figure figure{e.patch, e.method, line_class, {}, {}, 0, {}};
  const Summary* cell = find_class(e.classes, line_class);
  if (cell == nullptr) return figure;
  figure.value = metric_value(*cell, metric);
  if (metric == "rms_m") figure.ci95 = cell->ci95_m;
  figure.n = metric_count(*cell, metric);
  figure.evaluated_share = cell->evaluated_share();
  return figure;
}

/// The gated figures, one for each patch and method that the gate concerns.
std::vector<Figure> figures(const Gate& gate,
                            const std::string& line_class,
                            const ResultFolder& folder) {
  std::vector<Figure> result;
  if (is_matching_metric(gate.metric)) {
    for (const Table1Row& row : folder.matching.rows) {
      if (!concerns(gate, row.patch, row.matcher)) continue;
      const MatchCounts& c = row.counts;
      result.push_back({row.patch,
                        row.matcher,
                        "",
                        metric_value(c, gate.metric),
                        {},
                        c.n_correct + c.n_false + c.n_missed,
                        {}});
    }
    return result;
  }
  for (const Evaluation& e : folder.evaluations) {
    if (concerns(gate, e.patch, e.method)) {
      result.push_back(accuracy_figure(e, line_class, gate.metric));
    }
  }
  return result;
}

/// The same cell's figure in the baseline.
std::optional<double> baseline_value(const Gate& gate,
                                     const Figure& figure,
                                     const ResultFolder* baseline) {
  if (baseline == nullptr) return std::nullopt;
  for (const Figure& f : figures(gate, gate.line_class, *baseline)) {
    if (f.patch == figure.patch && f.method == figure.method) return f.value;
  }
  return std::nullopt;
}

GateResult begin_result(const Gate& gate, const Figure& figure, std::string rule) {
  GateResult result;
  result.rule = figure.line_class.empty()
                    ? fmt::format("{} {}", gate.metric, rule)
                    : fmt::format("{} {} {}", figure.line_class, gate.metric, rule);
  result.patch = figure.patch;
  result.method = figure.method;
  result.line_class = figure.line_class;
  result.metric = gate.metric;
  result.value = figure.value;
  result.ci95 = figure.ci95;
  result.n = figure.n;
  result.evaluated_share = figure.evaluated_share;
  return result;
}

enum class Bound : std::uint8_t { kUpper, kLower };

/// Settles value against limit. Written so that a value that is not a number fails.
GateResult settle(GateResult result, std::size_t n_min, Bound bound) {
  if (!result.value || !result.limit) {
    result.verdict = Verdict::kMissing;
    if (result.explanation.empty()) result.explanation = "the figure does not exist";
    return result;
  }
  if (result.n < n_min) {
    result.verdict = Verdict::kInsufficient;
    result.explanation = fmt::format("n = {}, at least {} are needed", result.n, n_min);
    return result;
  }
  const bool holds =
      bound == Bound::kUpper ? *result.value <= *result.limit : *result.value >= *result.limit;
  result.verdict = holds ? Verdict::kPassed : Verdict::kFailed;
  if (!holds) {
    result.explanation = fmt::format("{:.4g} is {} the limit {:.4g}", *result.value,
                                     bound == Bound::kUpper ? "above" : "below", *result.limit);
  }
  return result;
}

GateResult apply_ratio(const Gate& gate, const Figure& figure, const ResultFolder& folder) {
  const std::string& other_class = *gate.max_ratio_to_class;
  GateResult result =
      begin_result(gate, figure, fmt::format("<= {} x {}", gate.ratio, other_class));
  for (const Figure& other : figures(gate, other_class, folder)) {
    if (other.patch != figure.patch || other.method != figure.method) continue;
    if (other.value) result.limit = gate.ratio * *other.value;
    result.n = std::min(figure.n, other.n);
  }
  if (!result.limit) result.explanation = "the figure of " + other_class + " does not exist";
  return settle(std::move(result), gate.n_min, Bound::kUpper);
}

GateResult against_baseline(const Gate& gate,
                            const Figure& figure,
                            const ResultFolder* baseline,
                            const BaselineAllowance& allowance,
                            Bound bound) {
  constexpr double kLeastIncrease = 0.002;
  constexpr double kIncreaseShare = 0.05;
  const bool upper = bound == Bound::kUpper;
  const std::optional<double> base = baseline_value(gate, figure, baseline);
  const double default_increase = std::max(kLeastIncrease, kIncreaseShare * base.value_or(0.0));
  const double default_decrease = is_matching_metric(gate.metric) ? 0.01 : 0.02;
  const double a = allowance.value.value_or(upper ? default_increase : default_decrease);
  GateResult result =
      begin_result(gate, figure,
                   fmt::format("{} baseline {} {:.4g}", upper ? "<=" : ">=", upper ? '+' : '-', a));
  result.baseline = base;
  if (!result.baseline) {
    result.explanation =
        baseline == nullptr ? "no baseline is given" : "the baseline does not have the figure";
    return settle(std::move(result), gate.n_min, bound);
  }
  result.limit = *result.baseline + (upper ? a : -a);
  result.baseline_can_be_tightened = result.value && (upper ? *result.value < *result.baseline - a
                                                            : *result.value > *result.baseline + a);
  return settle(std::move(result), gate.n_min, bound);
}

void apply_to_figure(const Gate& gate,
                     const Figure& figure,
                     const ResultFolder& folder,
                     const ResultFolder* baseline,
                     std::vector<GateResult>& results) {
  const auto apply_limit = [&](std::optional<double> limit, Bound bound) {
    if (!limit) return;
    GateResult result = begin_result(
        gate, figure, fmt::format("{} {}", bound == Bound::kUpper ? "<=" : ">=", *limit));
    result.limit = limit;
    results.push_back(settle(std::move(result), gate.n_min, bound));
  };
  apply_limit(gate.max, Bound::kUpper);
  apply_limit(gate.min, Bound::kLower);
  if (gate.max_ratio_to_class) results.push_back(apply_ratio(gate, figure, folder));
  if (gate.max_increase_over_baseline) {
    results.push_back(
        against_baseline(gate, figure, baseline, *gate.max_increase_over_baseline, Bound::kUpper));
  }
  const bool coverage_with_baseline =
      gate.metric == "evaluated_share" && gate.min && baseline != nullptr;
  if (gate.max_decrease_below_baseline || coverage_with_baseline) {
    results.push_back(against_baseline(
        gate, figure, baseline, gate.max_decrease_below_baseline.value_or(BaselineAllowance{}),
        Bound::kLower));
  }
}

/// The cell that a gate names although the results do not have it.
Figure missing_figure(const Gate& gate) {
  return {gate.patch.value_or("(any)"),
          gate.method.value_or("(any)"),
          is_matching_metric(gate.metric) ? "" : gate.line_class,
          {},
          {},
          0,
          {}};
}

void warn_of_calibration(const Evaluation& e, std::vector<std::string>& warnings) {
  std::vector<std::size_t> all(e.lines.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Calibration c = calibrate(e.lines, all, std::string(kTotal), e.options.sigma_sys_m);
  if (!c.nees_per_dof || (*c.nees_per_dof >= 0.5 && *c.nees_per_dof <= 2.0)) return;
  warnings.push_back(fmt::format(
      "patch {}, {}: mean NEES / dof = {:.3g} (n = {}), outside [0.5, 2]: the predicted "
      "sigmas are too {}",
      e.patch, e.method, *c.nees_per_dof, c.n, *c.nees_per_dof > 1.0 ? "small" : "large"));
}

void warn_of_time(const ResultFolder& results,
                  const ResultFolder* baseline,
                  std::vector<std::string>& warnings) {
  constexpr double kMaxSlowdown = 2.0;
  if (baseline == nullptr || !baseline->duration_s || !results.duration_s) return;
  if (*results.duration_s <= kMaxSlowdown * *baseline->duration_s) return;
  warnings.push_back(fmt::format("time {:.1f} s is above twice the baseline's {:.1f} s",
                                 *results.duration_s, *baseline->duration_s));
}

}  // namespace

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
  for (const Gate& gate : gates) check_gate(gate);
  if (baseline != nullptr) check_same_inputs(results, *baseline);
  GateReport report;
  for (const Gate& gate : gates) {
    std::vector<Figure> gated = figures(gate, gate.line_class, results);
    if (gated.empty()) gated.push_back(missing_figure(gate));
    for (const Figure& figure : gated) {
      apply_to_figure(gate, figure, results, baseline, report.results);
    }
  }
  for (const Evaluation& e : results.evaluations) warn_of_calibration(e, report.warnings);
  warn_of_time(results, baseline, report.warnings);
  return report;
}

}  // namespace ridgeline::evaluate
