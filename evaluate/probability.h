// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline::evaluate {

// Probability distributions from Boost.Math, whose headers take seconds to compile.

/// Standard normal distribution. Throws std::domain_error for a probability outside [0, 1] and
/// std::overflow_error for 0 or 1.
double normal_quantile(double probability);
double normal_cdf(double z);
/// 1 - normal_cdf(z), accurate for small values too.
double normal_tail(double z);

/// Chi-square distribution: the value exceeded with probability 1 - `probability`, or with
/// probability `tail` for the upper quantile.
/// @param dof  degrees of freedom, above 0
double chi_square_quantile(double dof, double probability);
double chi_square_upper_quantile(double dof, double tail);

/// Student's t distribution.
double student_t_quantile(double dof, double probability);

}  // namespace ridgeline::evaluate
