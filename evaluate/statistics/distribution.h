// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Sum whose rounding error does not grow with the number of terms (Neumaier 1974), so that the
/// sums of disjoint parts add up to the total to about 1e-15 relative.
class CompensatedSum {
 public:
  void add(double x);
  [[nodiscard]] double value() const { return sum_ + compensation_; }

 private:
  double sum_ = 0.0, compensation_ = 0.0;
};

double sum(std::span<const double> values);
double sum_of_squares(std::span<const double> values);
/// Root mean square; empty for no values.
std::optional<double> rms(std::span<const double> values);

/// Quantile by linear interpolation between order statistics (type 7 of Hyndman and Fan 1996, the
/// default of R and NumPy). Empty for no values.
/// Throws std::invalid_argument unless `share` is in [0, 1].
std::optional<double> quantile(std::vector<double> values, double share);
std::optional<double> median(std::vector<double> values);

/// Normalised median absolute deviation 1.4826 median |v - median v|. It estimates the standard
/// deviation of a normal distribution, with a breakdown point of 50 %. The values must be signed;
/// for magnitudes it has a different meaning. Empty for no values.
std::optional<double> nmad(std::span<const double> signed_values);

}  // namespace ridgeline::evaluate
