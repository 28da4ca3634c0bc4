// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace ridgeline::io::laz {

/// Approximate median of the values seen, from five values kept sorted. A new value displaces the
/// largest of them if the previous value lay in the lower half, and the smallest if it lay in the
/// upper half.
class RunningMedian {
 public:
  std::int32_t get() const { return values_[2]; }

  void add(std::int32_t value) {
    if (drops_largest_) {
      drops_largest_ = value < values_[2];
      insert_downwards(value);
    } else {
      drops_largest_ = !(values_[2] < value);
      insert_upwards(value);
    }
  }

 private:
  void insert_downwards(std::int32_t value) {
    std::size_t i = 4;
    for (; i > 0 && value < values_[i - 1]; --i) values_[i] = values_[i - 1];
    values_[i] = value;
  }

  void insert_upwards(std::int32_t value) {
    std::size_t i = 0;
    for (; i < 4 && values_[i + 1] < value; ++i) values_[i] = values_[i + 1];
    values_[i] = value;
  }

  std::array<std::int32_t, 5> values_{};
  bool drops_largest_ = true;
};

}  // namespace ridgeline::io::laz
