// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/calibration.h"

#include "evaluate/statistics/distribution.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::evaluate {

Calibration calibrate(std::span<const LineEvaluation> lines,
                      std::span<const std::size_t> members,
                      std::string label,
                      double sigma_sys_m) {
  constexpr double kTwoSided95 = 1.96 * 1.96;
  constexpr double kTwoSided999 = 3.2905 * 3.2905;
  std::vector<double> z2;
  std::vector<double> sigmas_m;
  for (const std::size_t i : members) {
    const LineEvaluation& line = lines[i];
    if (line.status != Status::kEvaluated || !line.sigma_line_m) continue;
    const double variance_m2 = *line.sigma_line_m * *line.sigma_line_m +
                               *line.sigma_plane_m * *line.sigma_plane_m +
                               sigma_sys_m * sigma_sys_m;
    if (!(variance_m2 > 0.0) || !std::isfinite(variance_m2)) continue;
    z2.push_back(*line.signed_mean_m * *line.signed_mean_m / variance_m2);
    sigmas_m.push_back(std::sqrt(variance_m2));
  }
  Calibration result;
  result.label = std::move(label);
  result.n = z2.size();
  if (z2.empty()) return result;
  const auto n = static_cast<double>(z2.size());
  result.nees_per_dof = sum(z2) / n;
  result.bounds95 = chi_square_ratio_bounds(z2.size());
  const auto share_within = [&](double limit) {
    return static_cast<double>(std::ranges::count_if(z2, [&](double v) { return v <= limit; })) / n;
  };
  result.coverage_1_96 = share_within(kTwoSided95);
  result.share_beyond_99_9 = 1.0 - share_within(kTwoSided999);
  result.median_z2 = median(std::move(z2));
  result.median_sigma_m = median(std::move(sigmas_m));
  return result;
}

}  // namespace ridgeline::evaluate
