// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/cost_layout.h"

#include <algorithm>

namespace ridgeline::reconstruct {

CostLayout::CostLayout(const DisparityRanges& ranges) : ranges_(ranges) {
  constexpr int kCell = DisparityRanges::kCell_px;
  const auto length_of_cell = [&](int start, int whole) {
    return static_cast<std::size_t>(std::min<int>(kCell, whole - start));
  };
  std::size_t longest = 0;
  for (int y = 0; y < ranges.size_px.height; y += kCell) {
    std::size_t length = 0;
    for (int x = 0; x < ranges.size_px.width; x += kCell) {
      before_cells_.push_back(length);
      length +=
          static_cast<std::size_t>(ranges.at(x, y).n) * length_of_cell(x, ranges.size_px.width);
    }
    rows_.push_back({size_, length});
    size_ += length * length_of_cell(y, ranges.size_px.height);
    longest = std::max(longest, length);
  }
  padded_row_size_ =
      longest + (static_cast<std::size_t>(ranges.size_px.width) + 1) * DisparityRange::kStep;
}

}  // namespace ridgeline::reconstruct
