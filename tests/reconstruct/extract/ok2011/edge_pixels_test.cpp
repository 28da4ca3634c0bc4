// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/edge_pixels.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

constexpr float kLogRounding = 1e-4F;  // logarithms of float

TEST(PeakOffset, IsExactForAGaussianAtAnyPosition) {
  for (const float sigma : {0.8F, 1.2F, 3.0F}) {
    for (const float peak : {-0.5F, -0.2F, 0.0F, 0.31F, 0.49F}) {
      const auto profile = [&](float x) {
        return 0.2F * std::exp(-0.5F * (x - peak) * (x - peak) / (sigma * sigma));
      };
      EXPECT_NEAR(peak_offset_px(profile(-1), profile(0), profile(1)), peak, kLogRounding);
    }
  }
}

TEST(PeakOffset, IsZeroOnAPlateauAndStaysWithinThePixel) {
  EXPECT_EQ(peak_offset_px(1.0F, 1.0F, 1.0F), 0.0F);
  EXPECT_EQ(peak_offset_px(0.0F, 1.0F, 0.0F), 0.0F);
  EXPECT_EQ(peak_offset_px(0.1F, 1.0F, 1.0F), 0.5F);
  EXPECT_EQ(peak_offset_px(0.0F, 1e-3F, 1.0F), 0.5F);
}

/// A vertical edge whose gradient is strongest at x = 10.3.
cv::Mat vertical_edge() {
  cv::Mat gradient(20, 20, CV_32FC2);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      const float d = static_cast<float>(x) - 10.3F;
      gradient.at<cv::Vec2f>(y, x) = {0.1F * std::exp(-0.5F * d * d), 0.0F};
    }
  }
  return gradient;
}

TEST(EdgePixelAt, FindsThePositionBelowAPixel) {
  const auto pixel = edge_pixel_at(vertical_edge(), 10, 7, 0.01F);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->position_px.x(), 10.3F, kLogRounding);
  EXPECT_EQ(pixel->position_px.y(), 7.0F);
}

TEST(EdgePixelAt, SuppressesTheNeighboursOfTheMaximumAndWeakEdges) {
  const cv::Mat gradient = vertical_edge();
  EXPECT_FALSE(edge_pixel_at(gradient, 9, 7, 0.01F));
  EXPECT_FALSE(edge_pixel_at(gradient, 11, 7, 0.01F));
  EXPECT_FALSE(edge_pixel_at(gradient, 10, 7, 0.2F));
}

TEST(EdgePixelAt, NothingWhereTheImageIsFlat) {
  const cv::Mat flat(5, 5, CV_32FC2, cv::Scalar::all(0));
  EXPECT_FALSE(edge_pixel_at(flat, 2, 2, 0.0F));
}

TEST(EdgePixelAt, TakesOneOfTwoEqualMaxima) {
  cv::Mat gradient(3, 4, CV_32FC2, cv::Scalar::all(0));
  gradient.at<cv::Vec2f>(1, 1) = gradient.at<cv::Vec2f>(1, 2) = {1.0F, 0.0F};
  EXPECT_NE(edge_pixel_at(gradient, 1, 1, 0.1F).has_value(),
            edge_pixel_at(gradient, 2, 1, 0.1F).has_value());
}

}  // namespace
}  // namespace ridgeline::reconstruct
