// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/noise_grid.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

/// A gradient whose strength is `left` in the left half of the image, `right` in the other one, and
/// twice that in the lower half.
cv::Mat quarters(float left, float right) {
  constexpr int kHalf = 2 * NoiseGrid::kBlock_px;
  cv::Mat gradient(2 * kHalf, 2 * kHalf, CV_32FC2, cv::Scalar(left, 0.0F));
  gradient.colRange(kHalf, gradient.cols).setTo(cv::Scalar(0.0F, right));
  gradient.rowRange(kHalf, gradient.rows) *= 2.0;
  return gradient;
}

TEST(NoiseGrid, IsTheSigmaOfTheGradientBetweenTheMiddlesOfBlocks) {
  constexpr float kRayleighMedian = 1.1774F;
  constexpr float kFloat = 1e-5F;  // rounding of single precision
  const NoiseGrid noise(quarters(0.1F, 0.3F), 0.0F);
  EXPECT_NEAR(noise.at(0, 0), 0.1F / kRayleighMedian, kFloat);
  EXPECT_NEAR(noise.at(255, 0), 0.3F / kRayleighMedian, kFloat);
  EXPECT_NEAR(noise.at(255, 255), 0.6F / kRayleighMedian, kFloat);
  // the place is half a pixel past the borders, a 128th of the way of a block
  EXPECT_NEAR(noise.at(128, 70), (0.2F + 0.2F / 128.0F) / kRayleighMedian, kFloat);
  EXPECT_NEAR(noise.at(70, 128), (0.15F + 0.1F / 128.0F) / kRayleighMedian, kFloat);
}

TEST(NoiseGrid, IsNeverBelowTheLowest) {
  EXPECT_EQ(NoiseGrid(quarters(0.0F, 0.0F), 0.002F).at(60, 60), 0.002F);
}

TEST(NoiseGrid, DisregardsPixelsWithoutData) {
  constexpr float kRayleighMedian = 1.1774F;
  constexpr float kFloat = 1e-5F;  // rounding of single precision
  cv::Mat gradient = quarters(0.1F, 0.1F).rowRange(0, 2 * NoiseGrid::kBlock_px).clone();
  cv::Mat has_data(gradient.size(), CV_8UC1, cv::Scalar(255));
  const int n_black = 3 * NoiseGrid::kBlock_px / 2;  // a block and most of the next one
  gradient.colRange(0, n_black + 10).setTo(0.0);
  has_data.colRange(0, n_black + 10).setTo(0);
  const NoiseGrid noise(gradient, 0.0F, {}, has_data);
  for (const int x : {0, 40, n_black, 250})
    EXPECT_NEAR(noise.at(x, 60), 0.1F / kRayleighMedian, kFloat);
  const NoiseGrid nowhere(gradient, 0.002F, {}, cv::Mat::zeros(gradient.size(), CV_8UC1));
  EXPECT_EQ(nowhere.at(60, 60), 0.002F);
}

TEST(NoiseGrid, OfAnAreaIsThatOfItsPixels) {
  const NoiseGrid noise(quarters(0.1F, 0.3F), 0.0F);
  const cv::Rect area(50, 40, 180, 150);
  const cv::Mat values = noise.in(area);
  ASSERT_EQ(values.size(), area.size());
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      ASSERT_EQ(values.at<float>(y, x), noise.at(area.x + x, area.y + y)) << x << ", " << y;
    }
  }
}

TEST(NoiseGrid, OfAWindowHasTheBlocksOfTheFrame) {
  const cv::Mat frame = quarters(0.1F, 0.3F);
  const NoiseGrid whole(frame, 0.0F);
  const cv::Point corner(37, 70);
  const NoiseGrid part(frame(cv::Rect(corner, cv::Size(200, 180))), 0.0F, corner);
  // beyond the middle of the first whole block
  for (const cv::Point& x : {cv::Point(100, 165), cv::Point(128, 200), cv::Point(190, 190)})
    EXPECT_EQ(part.at(x.x - corner.x, x.y - corner.y), whole.at(x.x, x.y));
}

}  // namespace
}  // namespace ridgeline::reconstruct
