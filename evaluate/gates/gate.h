// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/decided_group.h"
#include "evaluate/statistics/interval.h"
#include "evaluate/tables/result_folder.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// How far a figure may rise above its baseline, in metres or as a share.
struct BaselineIncrease {
  std::optional<double> value;  ///< if empty, max(0.002 m, 5 % of the baseline); set for a share
};

/// Which value a gate compares with its limit.
enum class GateBound : std::uint8_t {
  kPoint,    ///< the estimate
  kUpper95,  ///< the upper end of its clustered 95 % interval
};
const char* name(GateBound bound);  ///< point | upper95

/// One entry of a gates file. Every rule that is set must hold, and at least one must be set.
struct Gate {
  std::optional<std::string> patch;   ///< if empty, every patch
  std::optional<std::string> method;  ///< or matcher; if empty, see figures_of()
  std::string line_class = "total";
  std::optional<int> n_images;             ///< only lines in this many images; 5: five or more
  std::optional<DecidedGroup> decided_by;  ///< only judged lines of this group
  std::optional<double> within_m;          ///< of building_metrics()
  std::string metric = "rms_m";            ///< see find_metric()
  std::optional<std::string> kind;         ///< of decoy_metrics(): height, across or match; of
                                           ///< scan_metrics(): ridge, hip, ..., default: all
  std::optional<double> distance_m;        ///< of decoy_metrics(): size of the displacement
  GateBound bound = GateBound::kPoint;     ///< kUpper95 only with `max`

  std::optional<double> max;
  std::optional<double> min;
  std::optional<std::string> max_ratio_to_class;  ///< figure <= ratio x the other class's figure
  double ratio = 2.5;
  std::optional<BaselineIncrease> max_increase_over_baseline;
  std::optional<double> max_decrease_below_baseline;

  std::optional<std::size_t> n_min;  ///< with fewer lines the gate is "insufficient", which fails
};

/// Throws std::invalid_argument for a gate that cannot be decided: one without a rule, with an
/// unknown metric, with a class for a matching figure, with a limit that is impossible for the
/// figure, or with GateBound::kUpper95 for a figure without a clustered interval or for a rule
/// other than `max`.
void validate(const Gate& gate);

enum class Verdict : std::uint8_t {
  kPassed,
  kFailed,
  kInsufficient,  ///< fewer lines than n_min, too few clusters or too wide an interval
  kMissing,       ///< the figure or its baseline is missing
};
const char* name(Verdict verdict);  ///< passed | failed | insufficient | missing

/// One rule applied to one cell.
struct GateResult {
  std::string rule;  ///< "aligned rms_m <= 0.3 (n >= 20)"
  std::string patch, method, line_class, metric;
  std::optional<int> n_images;             ///< see Gate
  std::optional<DecidedGroup> decided_by;  ///< see Gate
  std::optional<double> value, limit, baseline;
  std::optional<Interval>
      ci95;  ///< its upper end is compared for kUpper95, else it is only printed
  GateBound bound = GateBound::kPoint;
  std::size_t n_clusters = 0;  ///< of the interval; 0 if it is not clustered
  std::size_t n = 0;
  std::optional<double> evaluated_share;
  Verdict verdict = Verdict::kMissing;
  std::string explanation;  ///< one sentence, empty if passed
  bool baseline_can_be_tightened = false;
};

struct GateReport {
  std::vector<GateResult> results;
  std::vector<std::string> warnings;  ///< see gate_warnings(); they never make a gate fail
  /// Whether every result passed. False without results, because then nothing was checked.
  [[nodiscard]] bool passed() const;
};

/// Applies every gate to the figures given by figures_of(). A missing figure fails, as does a
/// baseline rule without a baseline. Point estimates are compared, because the figures are
/// deterministic, unless the gate requests GateBound::kUpper95, which requires kMinClusters
/// clusters. A share of decoys whose interval is wider than its limit is insufficient. Throws
/// std::invalid_argument for a gate that validate() rejects, or a baseline whose input hashes are
/// missing or differ.
GateReport apply_gates(std::span<const Gate> gates,
                       const ResultFolder& results,
                       const ResultFolder* baseline = nullptr);

}  // namespace ridgeline::evaluate
