// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/colour_gradient.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

constexpr float kGradientRounding = 1e-5F;  // float kernels of nine taps on values up to 10

/// A ramp of slope `slopes[band]` along (c, s).
cv::Mat ramps(const std::vector<double>& slopes, double c, double s) {
  cv::Mat image(30, 30, CV_32FC(static_cast<int>(slopes.size())));
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 30; ++x) {
      for (std::size_t band = 0; band < slopes.size(); ++band) {
        image.ptr<float>(y)[x * slopes.size() + band] =
            static_cast<float>(slopes[band] * (c * x + s * y));
      }
    }
  }
  return image;
}

TEST(ColourGradient, IsTheSlopeOfARampInEveryDirection) {
  for (const double angle_rad : {0.0, 0.4, M_PI_2, 2.0, M_PI, -1.1}) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    const auto g = colour_gradient(ramps({0.1}, c, s), 0.8).at<cv::Vec2f>(15, 15);
    EXPECT_NEAR(g[0], 0.1 * c, kGradientRounding) << angle_rad;
    EXPECT_NEAR(g[1], 0.1 * s, kGradientRounding) << angle_rad;
  }
}

TEST(ColourGradient, AddsTheSquaresOfTheBands) {
  const auto g = colour_gradient(ramps({0.03, 0.04}, 0.0, 1.0), 0.8).at<cv::Vec2f>(15, 15);
  EXPECT_NEAR(g[0], 0.0, kGradientRounding);
  EXPECT_NEAR(g[1], 0.05, kGradientRounding);
}

TEST(ColourGradient, SeesAnEdgeOfColourWithoutBrightness) {
  const auto g = colour_gradient(ramps({0.1, -0.1}, 1.0, 0.0), 0.8).at<cv::Vec2f>(15, 15);
  EXPECT_NEAR(std::abs(g[0]), 0.1 * M_SQRT2, kGradientRounding);
}

TEST(ColourGradient, PointsToTheBrighterSide) {
  const auto g = colour_gradient(ramps({-0.1, 0.05}, 1.0, 0.0), 0.8).at<cv::Vec2f>(15, 15);
  EXPECT_LT(g[0], 0.0F);
}

TEST(ColourGradient, OfAPartOfAnImageIsThePartOfItsGradient) {
  cv::Mat image(40, 40, CV_32FC3);
  cv::RNG random(5);
  random.fill(image, cv::RNG::UNIFORM, 0.0, 1.0);
  const cv::Rect part(7, 11, 16, 9);
  const cv::Mat whole = colour_gradient(image, 0.8);
  EXPECT_LT(cv::norm(colour_gradient(image(part), 0.8), whole(part), cv::NORM_INF),
            kGradientRounding);
}

TEST(ColourGradient, IsZeroInAFlatImage) {
  const cv::Mat gradient = colour_gradient(cv::Mat(1, 1, CV_32FC3, cv::Scalar::all(0.3)), 0.8);
  EXPECT_LT(cv::norm(gradient), kGradientRounding);
}

}  // namespace
}  // namespace ridgeline::reconstruct
