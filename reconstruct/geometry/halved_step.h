// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace ridgeline::reconstruct {

/// The state after a Gauss-Newton step, which is halved until the sum of squares does not grow: where
/// conditions nearly coincide, the linear range is smaller than the step. Nothing if the sum grows for
/// the smallest step as well.
/// @param sum       before the step, in standard deviations squared
/// @param state_at  the state after a share of the step
/// @param sum_of    the sum of squares of a state
template <typename StateAt, typename SumOf>
auto halved_step(double sum, const StateAt& state_at, const SumOf& sum_of)
    -> std::optional<decltype(state_at(1.0))> {
  constexpr int kMostTries = 10;
  constexpr double kRounding = 1e-9;  // of a sum whose unit is one standard deviation squared
  double share = 1.0;
  for (int i = 0; i < kMostTries; ++i, share *= 0.5) {
    auto state = state_at(share);
    if (sum_of(state) <= sum * (1.0 + kRounding) + kRounding) return state;
  }
  return std::nullopt;
}

}  // namespace ridgeline::reconstruct
