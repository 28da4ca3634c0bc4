// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

namespace ridgeline::evaluate {

/// A confidence interval, in the unit of the quantity.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

inline constexpr double kDefaultLevel = 0.95;

/// Interval of an RMS of independent, normal, zero-mean values with the given degrees of freedom
/// (n; for a standard deviation n - 1):
///   [rms sqrt(dof / chi2_{dof, 1 - a/2}), rms sqrt(dof / chi2_{dof, a/2})], a = 1 - level.
/// Lines of one roof are not independent, and the interval is then too narrow; see
/// clustered_bootstrap(). Empty for zero degrees of freedom. Throws std::invalid_argument unless
/// rms >= 0 and 0 < level < 1.
std::optional<Interval> chi_square_rms_interval(double rms,
                                                std::size_t dof,
                                                double level = kDefaultLevel);

/// Bounds of chi2 / dof. The mean of normalised squared errors lies between them if the covariances
/// are correct. Empty for zero degrees of freedom. Throws std::invalid_argument unless 0 < level <
/// 1.
std::optional<Interval> chi_square_ratio_bounds(std::size_t dof, double level = kDefaultLevel);

/// Score interval of a proportion (Wilson 1927); within [0, 1] even for 0 or all successes. Empty
/// for no trials. Throws std::invalid_argument for more successes than trials or a level outside
/// (0, 1).
std::optional<Interval> wilson_interval(std::size_t successes,
                                        std::size_t trials,
                                        double level = kDefaultLevel);

}  // namespace ridgeline::evaluate
