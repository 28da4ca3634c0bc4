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

/// A line that comes out nearer than this to its planes passes for a right one.
inline constexpr double kRight_m = 0.2;

/// A line that was moved on purpose, judged.
struct JudgedDecoy {
  Decoy decoy;
  LineEvaluation evaluation;
};

/// P(comes out within kRight_m | wrong by that much): the decoys of one kind and distance whose
/// lines were evaluated. Says nothing on how many lines are wrong.
struct DecoyFigure {
  DecoyKind kind = DecoyKind::kHeight;
  double distance_m = 0.0;
  std::size_t n_lines = 0;     ///< that were moved so, in either sense
  std::size_t n_decoys = 0;    ///< the denominator of both shares
  std::size_t n_passed = 0;    ///< evaluated, and nearer than kRight_m
  std::size_t n_withheld = 0;  ///< not evaluated
  std::size_t n_clusters = 0;
  std::optional<Interval> ci95;  ///< of share(), see decoy_figures()

  [[nodiscard]] std::optional<double> share() const;
  [[nodiscard]] std::optional<double> withheld_share() const;
};

/// The figures by kind and distance, without those of no decoy. `lines`: the lines that the decoys
/// were made of, judged. The interval is that of a bootstrap over cluster_labels() of these lines,
/// since decoys of one roof share its planes; it also holds the Wilson interval of independent
/// decoys, because a share of 0 has no spread to be resampled. Throws std::invalid_argument for a
/// decoy of a line that is not there.
std::vector<DecoyFigure> decoy_figures(std::span<const JudgedDecoy> decoys,
                                       std::span<const LineEvaluation> lines,
                                       const BootstrapOptions& options);

}  // namespace ridgeline::evaluate
