// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/bootstrap.h"
#include "evaluate/statistics/decoy_figures.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// Whether lines fit the cloud better than the same lines moved elsewhere. Lines that belong to
/// another place fit in neither position.
struct CloudFollowing {
  /// Number of moves for which the cloud can distinguish the two positions: both were judged, and
  /// the heights of their surfaces differ by more than 2 kRight_m. On level ground a line fits
  /// everywhere.
  std::size_t n_pairs = 0;
  std::size_t n_clusters = 0;
  double share = 0.0;            ///< of the lines within kRight_m in their own position
  double share_elsewhere = 0.0;  ///< of the same lines after they were moved
  std::optional<Interval> ci95;  ///< of the difference, from a bootstrap over clusters

  [[nodiscard]] double difference() const { return share - share_elsewhere; }

  /// Whether there are enough pairs for an answer.
  [[nodiscard]] bool is_known() const;
  /// The lines fit no better in their own position: the interval of the difference includes 0 or
  /// lies below it, and ends below 0.15, so that it is not merely wide for lack of data.
  [[nodiscard]] bool is_of_another_place() const;
  /// The difference is below 0.3.
  [[nodiscard]] bool is_weak() const;
};

/// Compares lines with themselves after move_elsewhere(). `evaluations` are the judgements of
/// `lines`; `shift_m` is a known shift common to all lines (zero if none), which is removed in both
/// positions: lines that lie 0.5 m too high do follow the cloud. Throws std::invalid_argument for
/// spans of different lengths and for a moved line whose original does not exist.
CloudFollowing cloud_following(std::span<const JudgedLine> lines,
                               std::span<const LineEvaluation> evaluations,
                               std::span<const JudgedDecoy> elsewhere,
                               const Eigen::Vector3d& shift_m,
                               const BootstrapOptions& options);

}  // namespace ridgeline::evaluate
