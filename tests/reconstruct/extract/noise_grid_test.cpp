// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/noise_grid.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

/// A gradient whose strength is `left` in the left half of the image and `right` in the other one.
cv::Mat halves(float left, float right) {
  cv::Mat gradient(150, 4 * NoiseGrid::kBlock_px, CV_32FC2, cv::Scalar(left, 0.0F));
  gradient.colRange(2 * NoiseGrid::kBlock_px, gradient.cols).setTo(cv::Scalar(0.0F, right));
  return gradient;
}

TEST(NoiseGrid, IsTheSigmaOfTheGradientBetweenTheMiddlesOfBlocks) {
  constexpr float kRayleighMedian = 1.1774F;
  constexpr float kFloat = 1e-5F;  // of single precision
  const NoiseGrid noise(halves(0.1F, 0.3F), 0.0F);
  EXPECT_NEAR(noise.at(0, 0), 0.1F / kRayleighMedian, kFloat);
  EXPECT_NEAR(noise.at(255, 149), 0.3F / kRayleighMedian, kFloat);
  // half a pixel past the border of the halves: a 128th of the way of a block
  EXPECT_NEAR(noise.at(128, 70), (0.2F + 0.2F / 128.0F) / kRayleighMedian, kFloat);
}

TEST(NoiseGrid, IsNeverBelowTheLowest) {
  EXPECT_EQ(NoiseGrid(halves(0.0F, 0.0F), 0.002F).at(60, 60), 0.002F);
}

TEST(NoiseGrid, OfAnAreaIsThatOfItsPixels) {
  const NoiseGrid noise(halves(0.1F, 0.3F), 0.0F);
  const cv::Rect area(50, 20, 180, 100);
  const cv::Mat values = noise.in(area);
  ASSERT_EQ(values.size(), area.size());
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      ASSERT_EQ(values.at<float>(y, x), noise.at(area.x + x, area.y + y)) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
