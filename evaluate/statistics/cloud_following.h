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

/// Whether lines fit the cloud better than the same lines elsewhere. Lines of another place fit
/// neither.
struct CloudFollowing {
  /// Of how many moves the cloud could tell: both places were judged, and the height of their
  /// surfaces differs by more than a line can be off and still pass. On level ground a line fits
  /// everywhere.
  std::size_t n_pairs = 0;
  std::size_t n_clusters = 0;
  double share = 0.0;            ///< of the lines within kRight_m where they lie
  double share_elsewhere = 0.0;  ///< of the same lines where they were moved to
  std::optional<Interval> ci95;  ///< of the difference, by a bootstrap over clusters

  [[nodiscard]] double difference() const { return share - share_elsewhere; }

  /// Whether the pairs are enough for an answer.
  [[nodiscard]] bool is_known() const;
  /// The lines fit no better where they lie: the interval of the difference holds 0 and nothing
  /// above 0.15, so that it is not wide because little is known.
  [[nodiscard]] bool is_of_another_place() const;
  /// The difference is below 0.3.
  [[nodiscard]] bool is_weak() const;
};

/// Compares lines with themselves where move_elsewhere() put them. `lines` were judged as
/// `evaluations`; `shift_m` is a shift that all of them are known to have (zero if none) and that
/// is taken away at both places: lines that lie 0.5 m too high do follow the cloud. Throws
/// std::invalid_argument for spans of different length and for a moved line of no line.
CloudFollowing cloud_following(std::span<const JudgedLine> lines,
                               std::span<const LineEvaluation> evaluations,
                               std::span<const JudgedDecoy> elsewhere,
                               const Eigen::Vector3d& shift_m,
                               const BootstrapOptions& options);

}  // namespace ridgeline::evaluate
