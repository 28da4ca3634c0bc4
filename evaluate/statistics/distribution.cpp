// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/distribution.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ridgeline::evaluate {

void CompensatedSum::add(double x) {
  const double total = sum_ + x;
  compensation_ += std::abs(sum_) >= std::abs(x) ? (sum_ - total) + x : (x - total) + sum_;
  sum_ = total;
}

double sum(std::span<const double> values) {
  CompensatedSum total;
  for (const double v : values) total.add(v);
  return total.value();
}

double sum_of_squares(std::span<const double> values) {
  CompensatedSum total;
  for (const double v : values) total.add(v * v);
  return total.value();
}

std::optional<double> rms(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  return std::sqrt(sum_of_squares(values) / static_cast<double>(values.size()));
}

std::optional<double> quantile(std::vector<double> values, double share) {
  check(share >= 0.0 && share <= 1.0, "quantile: share = ", share, ", must be in [0, 1]");
  if (values.empty()) return std::nullopt;
  const double position = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), nth, values.end());
  const double low = *nth;
  if (below + 1 == values.size()) return low;
  const double high = *std::min_element(nth + 1, values.end());
  return low + (position - static_cast<double>(below)) * (high - low);
}

std::optional<double> median(std::vector<double> values) {
  return quantile(std::move(values), 0.5);
}

std::optional<double> nmad(std::span<const double> signed_values) {
  constexpr double kNormalConsistency = 1.4826;  // 1 / Phi^-1(3/4)
  std::vector<double> deviations(signed_values.begin(), signed_values.end());
  const std::optional<double> centre = median(deviations);
  if (!centre) return std::nullopt;
  for (double& v : deviations) v = std::abs(v - *centre);
  return kNormalConsistency * *median(std::move(deviations));
}

}  // namespace ridgeline::evaluate
