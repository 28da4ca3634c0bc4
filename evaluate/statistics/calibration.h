// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/interval.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace ridgeline::evaluate {

/// Whether predicted standard deviations agree with the observed distances:
///   z = signed distance / sqrt(sigma_line^2 + sigma_plane^2 + sigma_sys^2).
struct Calibration {
  std::string label;
  std::size_t n = 0;  ///< evaluated lines with a predicted sigma
  /// Mean normalised squared error per degree of freedom, mean z^2. It is 1 if sigma is correct,
  /// larger if sigma is optimistic and smaller if it is pessimistic. A few lines judged by a wrong
  /// surface can dominate this mean; `median_z2` and the shares describe the other lines.
  std::optional<double> nees_per_dof;
  std::optional<double> share_beyond_99_9;  ///< share of |z| > 3.29; 0.1 % if z is standard normal
  std::optional<Interval> bounds95;         ///< of nees_per_dof if sigma is correct
  std::optional<double> median_z2;          ///< 0.455 if z is standard normal
  std::optional<double> coverage_1_96;      ///< share of |z| <= 1.96; 95 % if z is standard normal
  std::optional<double> median_sigma_m;     ///< median of the predicted sigmas
  [[nodiscard]] bool optimistic() const { return bounds95 && *nees_per_dof > bounds95->high; }
  [[nodiscard]] bool pessimistic() const { return bounds95 && *nees_per_dof < bounds95->low; }
};

/// Calibration of the lines whose index is in `members`. Lines that have no covariance, are not
/// evaluated or have a predicted sigma of 0 are ignored. sigma_sys_m: see SummaryOptions.
Calibration calibrate(std::span<const LineEvaluation> lines,
                      std::span<const std::size_t> members,
                      std::string label,
                      double sigma_sys_m);

}  // namespace ridgeline::evaluate
