// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/interval.h"

#include "evaluate/probability.h"
#include "reconstruct/geometry/check.h"

#include <cmath>

namespace ridgeline::evaluate {
namespace {

void check_level(double level) {
  check(level > 0.0 && level < 1.0, "level = ", level, ", must be in (0, 1)");
}

}  // namespace

std::optional<Interval> chi_square_ratio_bounds(std::size_t dof, double level) {
  check_level(level);
  if (dof == 0) return std::nullopt;
  const auto k = static_cast<double>(dof);
  const double tail = 0.5 * (1.0 - level);
  return Interval{chi_square_quantile(k, tail) / k, chi_square_upper_quantile(k, tail) / k};
}

std::optional<Interval> chi_square_rms_interval(double rms, std::size_t dof, double level) {
  check(rms >= 0.0, "chi_square_rms_interval: rms = ", rms, ", must be >= 0");
  const std::optional<Interval> ratio = chi_square_ratio_bounds(dof, level);
  if (!ratio) return std::nullopt;
  return Interval{rms / std::sqrt(ratio->high), rms / std::sqrt(ratio->low)};
}

std::optional<Interval> wilson_interval(std::size_t successes, std::size_t trials, double level) {
  check_level(level);
  check(successes <= trials, "wilson_interval: successes = ", successes, ", must be <= ", trials);
  if (trials == 0) return std::nullopt;
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double z = normal_quantile(0.5 * (1.0 + level));
  const double centre = p + z * z / (2.0 * n);
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  const double scale = 1.0 / (1.0 + z * z / n);
  // the ends are set exactly, because rounding would leave them off by 1e-17
  return Interval{successes == 0 ? 0.0 : scale * (centre - half),
                  successes == trials ? 1.0 : scale * (centre + half)};
}

}  // namespace ridgeline::evaluate
