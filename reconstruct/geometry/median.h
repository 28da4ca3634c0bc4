// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ridgeline {

/// The middle of n > 0 values in sorted order; for even n, the larger of the two middle values.
/// Unlike evaluate::median(), the result is always one of the values.
template <typename T>
T upper_median(std::vector<T> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace ridgeline
