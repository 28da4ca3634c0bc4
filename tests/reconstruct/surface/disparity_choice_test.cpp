// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/disparity_choice.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

constexpr int kOfPixel = 8;
using Costs = std::vector<std::uint16_t>;

std::vector<float> chosen(int n_pixels, const Costs& costs, int first = 0, int n_all = kOfPixel) {
  DisparityRanges ranges = all_disparities({n_pixels, 1}, n_all);
  for (DisparityRange& range : ranges.of_cells) range = {first, kOfPixel};
  std::vector<float> disparities_px(static_cast<std::size_t>(n_pixels));
  DisparityChoice(ranges).of_row(0, costs.data(), disparities_px.data());
  return disparities_px;
}

TEST(DisparityChoice, IsTheCheapestToAPartOfAPixel) {
  // The parabola (k - 2.75)^2 times 16, above 400.
  const Costs parabola{521, 449, 409, 401, 425, 481, 569, 689};
  EXPECT_FLOAT_EQ(chosen(1, parabola, 0)[0], 2.75F);
  EXPECT_FLOAT_EQ(chosen(1, parabola, 16, 32)[0], 18.75F);
}

TEST(DisparityChoice, LeavesOutWhatTwoDisparitiesExplain) {
  EXPECT_LT(chosen(1, {900, 900, 500, 900, 900, 526, 900, 900})[0], 0.0F);
  EXPECT_GT(chosen(1, {900, 900, 500, 900, 900, 527, 900, 900})[0], 0.0F);  // 527 * 0.95 > 500
  EXPECT_GT(chosen(1, {900, 900, 500, 501, 900, 900, 900, 900})[0],
            0.0F);  // a neighbour may be alike
}

TEST(DisparityChoice, LeavesOutTheEndsOfARangeUnlessThereIsNoMore) {
  const Costs lowest{100, 500, 900, 900, 900, 900, 900, 900};
  const Costs highest{900, 900, 900, 900, 900, 900, 500, 100};
  EXPECT_LT(chosen(1, lowest, 8, 24)[0], 0.0F);
  EXPECT_LT(chosen(1, highest, 8, 24)[0], 0.0F);
  EXPECT_FLOAT_EQ(chosen(1, lowest)[0], 0.0F);
  EXPECT_FLOAT_EQ(chosen(1, highest)[0], 7.0F);
}

TEST(DisparityChoice, LeavesOutWhatThePixelOfTheRightViewContradicts) {
  const Costs at_2{900, 900, 500, 900, 900, 900, 900, 900};
  const Costs at_5{900, 900, 900, 900, 900, 100, 900, 900};
  Costs costs;  // columns 0 and 3 are seen in the same column of the right view
  for (const Costs& pixel : {at_2, at_2, at_2, at_5})
    costs.insert(costs.end(), pixel.begin(), pixel.end());
  const std::vector<float> found = chosen(4, costs);
  EXPECT_LT(found[0], 0.0F);
  EXPECT_FLOAT_EQ(found[1], 2.0F);
  EXPECT_FLOAT_EQ(found[3], 5.0F);
}

TEST(DisparityChoice, IsNoneInAnEmptyRange) {
  const DisparityRanges ranges = all_disparities({3, 1}, 0);
  std::vector<float> disparities_px(3);
  DisparityChoice(ranges).of_row(0, nullptr, disparities_px.data());
  for (const float d : disparities_px) EXPECT_LT(d, 0.0F);
}

TEST(DisparityChoice, TakesTheLargestCosts) {
  const Costs most(kOfPixel, UINT16_MAX);
  EXPECT_LT(chosen(1, most)[0], 0.0F);
}

}  // namespace
}  // namespace ridgeline::reconstruct
