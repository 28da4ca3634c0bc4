// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/bootstrap.h"
#include "evaluate/statistics/decoys.h"
#include "evaluate/statistics/interval.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// A line whose mean distance from its planes is below this passes as correct.
inline constexpr double kRight_m = 0.2;

/// A line that was moved deliberately, and its judgement.
struct JudgedDecoy {
  Decoy decoy;
  LineEvaluation evaluation;
};

/// P(judged to be within kRight_m | wrong by that much): the decoys of one kind and distance whose
/// original lines were evaluated. This says nothing about how many lines are wrong.
struct DecoyFigure {
  DecoyKind kind = DecoyKind::kHeight;
  double distance_m = 0.0;
  std::size_t n_lines = 0;     ///< original lines moved in this way, in either direction
  std::size_t n_decoys = 0;    ///< the denominator of both shares
  std::size_t n_passed = 0;    ///< evaluated, and nearer than kRight_m
  std::size_t n_withheld = 0;  ///< not evaluated
  std::size_t n_clusters = 0;
  std::optional<Interval> ci95;  ///< of share(); see decoy_figures()

  [[nodiscard]] std::optional<double> share() const;
  [[nodiscard]] std::optional<double> withheld_share() const;
};

/// The figures by kind and distance; combinations without decoys are omitted. `lines`: the judged
/// lines from which the decoys were made. The interval comes from a bootstrap over cluster_labels()
/// of these lines, since decoys of one roof share its planes; it also includes the Wilson interval
/// of independent decoys, because a share of 0 has no spread to be resampled. Throws
/// std::invalid_argument for a decoy whose line does not exist.
std::vector<DecoyFigure> decoy_figures(std::span<const JudgedDecoy> decoys,
                                       std::span<const LineEvaluation> lines,
                                       const BootstrapOptions& options);

}  // namespace ridgeline::evaluate
