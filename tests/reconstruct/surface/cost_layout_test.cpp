// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/cost_layout.h"

#include <gtest/gtest.h>

namespace ridgeline::reconstruct {
namespace {

TEST(CostLayout, KeepsTheCostsOfAllPixelsOneAfterTheOther) {
  DisparityRanges ranges = all_disparities({40, 19}, 32);  // the last cells are cut off
  ranges.of_cells[1] = {8, 16};
  ranges.of_cells[3] = {0, 0};
  ranges.of_cells[4] = {24, 8};
  const CostLayout layout(ranges);
  std::size_t next = 0;
  for (int y = 0; y < ranges.size_px.height; ++y) {
    std::size_t in_row = 0;
    for (int x = 0; x < ranges.size_px.width; ++x) {
      const auto n = static_cast<std::size_t>(ranges.at(x, y).n);
      EXPECT_EQ(layout.at(x, y), next);
      EXPECT_EQ(layout.in_padded_row(x, y), in_row + DisparityRange::kStep);
      next += n;
      in_row += n + DisparityRange::kStep;
      EXPECT_LE(in_row + DisparityRange::kStep, layout.padded_row_size());
    }
  }
  EXPECT_EQ(layout.size(), next);
}

TEST(CostLayout, OfNothingIsEmpty) {
  EXPECT_EQ(CostLayout(all_disparities({20, 20}, 0)).size(), 0U);
}

}  // namespace
}  // namespace ridgeline::reconstruct
