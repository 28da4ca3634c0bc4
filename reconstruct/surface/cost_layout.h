// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/disparity_ranges.h"

#include <cstddef>
#include <vector>

namespace ridgeline::reconstruct {

/// The memory layout of the costs of the disparities of all pixels: row by row, with the costs of a
/// pixel next to each other. It keeps a reference to the ranges.
class CostLayout {
 public:
  explicit CostLayout(const DisparityRanges& ranges);

  /// Number of costs.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Index of the first cost of a pixel.
  [[nodiscard]] std::size_t at(int x, int y) const {
    const RowOfCells& row = rows_[static_cast<std::size_t>(y / DisparityRanges::kCell_px)];
    const auto y_in_cell = static_cast<std::size_t>(y % DisparityRanges::kCell_px);
    return row.start + y_in_cell * row.row_length + in_row(x, y);
  }

  /// Number of costs of the longest row, including DisparityRange::kStep padding costs before and
  /// after every pixel.
  [[nodiscard]] std::size_t padded_row_size() const { return padded_row_size_; }
  /// Index of the first cost of a pixel in such a row.
  [[nodiscard]] std::size_t in_padded_row(int x, int y) const {
    return in_row(x, y) + (static_cast<std::size_t>(x) + 1) * DisparityRange::kStep;
  }

 private:
  struct RowOfCells {
    std::size_t start = 0, row_length = 0;
  };
  [[nodiscard]] std::size_t in_row(int x, int y) const {
    const std::size_t cell = ranges_.cell_at(x, y);
    const auto x_in_cell = static_cast<std::size_t>(x % DisparityRanges::kCell_px);
    return before_cells_[cell] + x_in_cell * static_cast<std::size_t>(ranges_.of_cells[cell].n);
  }

  const DisparityRanges& ranges_;
  std::vector<RowOfCells> rows_;
  std::vector<std::size_t> before_cells_;  ///< number of costs in a row before each cell
  std::size_t size_ = 0, padded_row_size_ = 0;
};

}  // namespace ridgeline::reconstruct
