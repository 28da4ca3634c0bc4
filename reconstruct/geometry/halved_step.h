// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace ridgeline::reconstruct {

/// The state after a Gauss-Newton step. The step is halved until the sum of squares does not grow,
/// because the problem is not linear over the full step if conditions nearly coincide. std::nullopt
/// if the sum grows even for the smallest step.
/// @param sum            the sum of squares before the step, in standard deviations squared
/// @param state_at       returns the state after the given share of the step
/// @param sum_of         returns the sum of squares of a state
/// @param largest_share  the share that is tried first
template <typename StateAt, typename SumOf>
auto halved_step(double sum,
                 const StateAt& state_at,
                 const SumOf& sum_of,
                 double largest_share = 1.0) -> std::optional<decltype(state_at(1.0))> {
  constexpr int kMaxTries = 10;
  // Both a relative and an absolute tolerance; the unit of the sum is one standard deviation
  // squared.
  constexpr double kRounding = 1e-9;
  double share = largest_share;
  for (int i = 0; i < kMaxTries; ++i, share *= 0.5) {
    auto state = state_at(share);
    if (sum_of(state) <= sum * (1.0 + kRounding) + kRounding) return state;
  }
  return std::nullopt;
}

}  // namespace ridgeline::reconstruct
