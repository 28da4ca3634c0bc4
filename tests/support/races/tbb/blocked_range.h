// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace tbb {

template <typename Index>
class blocked_range {
 public:
  blocked_range(Index begin, Index end, std::size_t grain = 1)
      : begin_(begin), end_(end), grain_(grain) {}
  [[nodiscard]] Index begin() const { return begin_; }
  [[nodiscard]] Index end() const { return end_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

  [[nodiscard]] std::size_t n_pieces() const { return (size() + grain_ - 1) / grain_; }
  [[nodiscard]] blocked_range piece(std::size_t i) const {
    const auto at = [this](std::size_t n) {
      return static_cast<Index>(begin_ + static_cast<Index>(n < size() ? n : size()));
    };
    return {at(i * grain_), at((i + 1) * grain_), grain_};
  }

 private:
  Index begin_, end_;
  std::size_t grain_;
};

}  // namespace tbb
