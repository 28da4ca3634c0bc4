// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/matching_cost.h"

#include "tests/reconstruct/support/rectified_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

constexpr int kAllCosts = 32;
constexpr std::int16_t kMaxCost = 5000;
constexpr std::int16_t kUntouched = -7;
const cv::Size kCostSize(24, 20);

/// Costs of the single row `row` of the view, from column `from` on.
std::vector<std::int16_t> costs_of(const test::RectifiedViews& views,
                                   const cv::Rect& cell,
                                   const DisparityRange& range,
                                   std::int16_t most = kMaxCost) {
  std::vector<std::int16_t> costs(static_cast<std::size_t>(cell.area() * range.n + 16), kUntouched);
  std::vector<std::int16_t*> rows;
  for (int j = 0; j < cell.height; ++j)
    rows.push_back(&costs[static_cast<std::size_t>(j * cell.width * range.n)]);
  MatchingCost(views.left, views.right, most).of_cell(cell, range, rows);
  EXPECT_TRUE(std::all_of(costs.end() - 16, costs.end(),
                          [](std::int16_t cost) { return cost == kUntouched; }));
  costs.resize(costs.size() - 16);
  return costs;
}

TEST(MatchingCost, IsZeroForPixelsThatAreTheSame) {
  for (const int n_bands : {1, 3}) {
    const auto views =
        test::rectified_views(kCostSize, n_bands, kAllCosts, [](int, int) { return 11; });
    const cv::Rect cell(8, 4, 6, 5);
    const DisparityRange range{8, 8};
    const auto costs = costs_of(views, cell, range);
    for (std::size_t k = 0; k < costs.size(); ++k)
      EXPECT_EQ(costs[k] == 0, k % 8 == 3) << n_bands << " bands, cost " << k;
  }
}

/// The difference of the grey values and gradients of two pixels of one band as the paper has it,
/// in doubles.
int plain_difference(const cv::Mat& left, int x, const cv::Mat& right, int x_right, int y) {
  const auto at = [](const cv::Mat& view, int column, int row) -> int {
    return view.at<unsigned char>(std::clamp(row, 0, view.rows - 1),
                                  std::clamp(column, 0, view.cols - 1));
  };
  const auto grey = [&](const cv::Mat& view, int column) { return at(view, column, y); };
  const auto gradient = [&](const cv::Mat& view, int column) {
    column = std::clamp(column, 0, view.cols - 1);
    int sum = 0;
    for (const int row : {-1, 0, 0, 1})
      sum += at(view, column + 1, y + row) - at(view, column - 1, y + row);
    return std::clamp(sum, -63, 63) + 63;
  };
  const auto outside = [&](const auto& value, const cv::Mat& of, int x_of, const cv::Mat& in,
                           int x_in) {
    const std::array within{value(in, x_in), (value(in, x_in) + value(in, x_in - 1)) / 2,
                            (value(in, x_in) + value(in, x_in + 1)) / 2};
    const auto [low, high] = std::ranges::minmax(within);
    return std::max({0, value(of, x_of) - high, low - value(of, x_of)});
  };
  const auto difference = [&](const auto& value) {
    return std::min(outside(value, left, x, right, x_right),
                    outside(value, right, x_right, left, x));
  };
  return difference(gradient) + difference(grey) / 4;
}

TEST(MatchingCost, IsTheSumOfDifferencesThatDoNotDependOnSampling) {
  const test::RectifiedViews views{
      test::texture(kCostSize, 1, 1),
      test::texture({kCostSize.width + kAllCosts, kCostSize.height}, 1, 2)};
  const DisparityRange range{4, 24};
  for (const cv::Rect& cell : {cv::Rect(0, 0, 3, 2), cv::Rect(16, 16, 8, 4)}) {
    const auto costs = costs_of(views, cell, range, INT16_MAX);
    for (int k = 0; k < static_cast<int>(costs.size()); ++k) {
      const int d = range.first + k % range.n;
      int expected = 0;
      for (int i = -2; i <= 2; ++i) {
        for (int j = -2; j <= 2; ++j) {
          const int x = std::clamp(cell.x + k / range.n % cell.width + i, 0, kCostSize.width - 1);
          const int y = std::clamp(cell.y + k / range.n / cell.width + j, 0, kCostSize.height - 1);
          expected += plain_difference(views.left, x, views.right, x + kAllCosts - d, y);
        }
      }
      ASSERT_EQ(costs[static_cast<std::size_t>(k)], expected) << k;
    }
  }
}

TEST(MatchingCost, IsBounded) {
  const test::RectifiedViews views{
      cv::Mat(kCostSize, CV_8UC3, cv::Scalar(0, 0, 0)),
      cv::Mat(kCostSize.height, kCostSize.width + kAllCosts, CV_8UC3, cv::Scalar(255, 255, 255))};
  for (const std::int16_t most : {std::int16_t{100}, kMaxCost}) {
    for (const std::int16_t cost : costs_of(views, {0, 0, 16, 16}, {0, 16}, most))
      EXPECT_EQ(cost, std::min<int>(most, 3 * 25 * 63));
  }
}

TEST(MatchingCost, OfASinglePixelIsThatOfItsGreyValues) {
  const test::RectifiedViews views{cv::Mat(1, 1, CV_8U, cv::Scalar(100)),
                                   cv::Mat(1, 1 + kAllCosts, CV_8U, cv::Scalar(140))};
  for (const std::int16_t cost : costs_of(views, {0, 0, 1, 1}, {0, kAllCosts}))
    EXPECT_EQ(cost, 25 * 10);
}

}  // namespace
}  // namespace ridgeline::reconstruct
