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

/// Which figure a gate compares with its limit.
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
  std::optional<int> n_images;             ///< only lines of so many images, 5 being five and more
  std::optional<DecidedGroup> decided_by;  ///< only judged lines of this group
  std::optional<double> within_m;          ///< of building_metrics()
  std::string metric = "rms_m";            ///< see find_metric()
  std::optional<std::string> kind;         ///< of decoy_metrics(): height, across or match
  std::optional<double> distance_m;        ///< of decoy_metrics(): how far lines were moved
  GateBound bound = GateBound::kPoint;     ///< kUpper95 belongs to `max`

  std::optional<double> max;
  std::optional<double> min;
  std::optional<std::string> max_ratio_to_class;  ///< figure <= ratio x the other class's figure
  double ratio = 2.5;
  std::optional<BaselineIncrease> max_increase_over_baseline;
  std::optional<double> max_decrease_below_baseline;

  std::optional<std::size_t> n_min;  ///< with fewer lines the gate is "insufficient", which fails
};

/// Throws std::invalid_argument for a gate that cannot decide: without a rule, with an unknown
/// metric, with a class for a figure of matching, with a limit that the figure cannot have, or with
/// GateBound::kUpper95 for a figure without a clustered interval or for another rule than `max`.
void validate(const Gate& gate);

enum class Verdict : std::uint8_t {
  kPassed,
  kFailed,
  kInsufficient,  ///< fewer lines than n_min, too few clusters or too wide an interval
  kMissing,       ///< the figure or its baseline does not exist
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
      ci95;  ///< its upper end is compared for GateBound::kUpper95, else it is only printed
  GateBound bound = GateBound::kPoint;
  std::size_t n_clusters = 0;  ///< of the interval; 0 if it is not of clusters
  std::size_t n = 0;
  std::optional<double> evaluated_share;
  Verdict verdict = Verdict::kMissing;
  std::string explanation;  ///< one sentence, empty if passed
  bool baseline_can_be_tightened = false;
};

struct GateReport {
  std::vector<GateResult> results;
  std::vector<std::string> warnings;  ///< see gate_warnings(); they never make a gate fail
  /// Whether every result passed. False without results: a gate that checked nothing has not
  /// passed.
  [[nodiscard]] bool passed() const;
};

/// Applies every gate to each figure that it concerns, see figures_of(). A figure that does not
/// exist fails, as does a baseline rule without a baseline. Point estimates are compared, as the
/// figures are deterministic, unless the gate asks for GateBound::kUpper95, which needs
/// kMinClusters clusters. A share of decoys whose interval is wider than its limit is insufficient.
/// Throws std::invalid_argument for a gate that validate() rejects, or a baseline whose input
/// hashes are missing or differ.
GateReport apply_gates(std::span<const Gate> gates,
                       const ResultFolder& results,
                       const ResultFolder* baseline = nullptr);

}  // namespace ridgeline::evaluate
