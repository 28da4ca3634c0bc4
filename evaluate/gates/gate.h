// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/interval.h"
#include "evaluate/tables/result_folder.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// How far a figure may move from its baseline, in its own unit.
struct BaselineAllowance {
  /// Empty: max(0.002, 5 % of the baseline) for an increase; for a decrease 0.02, of a matching
  /// figure 0.01.
  std::optional<double> value;
};

/// One entry of a gates file. Every rule that is set must hold, at least one must be set.
struct Gate {
  std::optional<std::string> patch;   ///< empty: every patch
  std::optional<std::string> method;  ///< empty: every method (matcher, for a matching figure)
  std::string line_class = "total";
  std::string metric = "rms_m";  ///< of accuracy_metrics() or matching_metrics()

  std::optional<double> max;
  std::optional<double> min;
  std::optional<std::string> max_ratio_to_class;  ///< figure <= ratio x the other class's figure
  double ratio = 2.5;
  std::optional<BaselineAllowance> max_increase_over_baseline;
  std::optional<BaselineAllowance> max_decrease_below_baseline;

  std::size_t n_min = 20;  ///< fewer lines: "insufficient", which fails
};

enum class Verdict : std::uint8_t {
  kPassed,
  kFailed,
  kInsufficient,  ///< fewer lines than n_min
  kMissing,       ///< the figure or its baseline does not exist
};
const char* name(Verdict verdict);  ///< passed | failed | insufficient | missing

/// One rule applied to one cell.
struct GateResult {
  std::string rule;  ///< "aligned rms_m <= 0.3"
  std::string patch, method, line_class, metric;
  std::optional<double> value, limit, baseline;
  std::optional<Interval> ci95;  ///< printed; the point estimate is what is compared
  std::size_t n = 0;
  std::optional<double> evaluated_share;
  Verdict verdict = Verdict::kMissing;
  std::string explanation;  ///< one sentence, empty if passed
  bool baseline_can_be_tightened = false;
};

struct GateReport {
  std::vector<GateResult> results;
  std::vector<std::string> warnings;  ///< calibration and time: they never fail
  /// False for no result: a gate that checked nothing has not passed.
  [[nodiscard]] bool passed() const;
};

/// Applies every gate to every cell that it names, or to each. A figure that does not exist fails,
/// as does a baseline rule without a baseline. A minimum of evaluated_share must also hold against
/// the baseline less 0.02, if there is one. Point estimates are compared: the figures are
/// deterministic.
/// Throws std::invalid_argument for a gate without a rule, an unknown metric, a limit that is not
/// finite, or a baseline whose input hashes are missing or differ.
GateReport apply_gates(std::span<const Gate> gates,
                       const ResultFolder& results,
                       const ResultFolder* baseline = nullptr);

}  // namespace ridgeline::evaluate
