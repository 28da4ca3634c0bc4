// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/normalised_image.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

constexpr float kStretchRounding = 1e-6F;  // a few steps of float at 1

/// Grey values 100, 101, ... 199 in turn.
template <typename T>
cv::Mat ramp(int type) {
  cv::Mat raw(100, 100, type);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) raw.at<T>(y, x) = static_cast<T>(100 + x);
  }
  return raw;
}

TEST(NormalisedImage, StretchesLinearlyToZeroAndOne) {
  const cv::Mat image = normalised_image(ramp<std::uint8_t>(CV_8UC1));
  ASSERT_EQ(image.type(), CV_32FC1);
  for (int x = 0; x < 100; ++x) {
    EXPECT_NEAR(image.at<float>(50, x), static_cast<float>(x) / 99.0F, kStretchRounding);
  }
}

TEST(NormalisedImage, DoesNotDependOnTheRadiometricDepth) {
  cv::Mat deep;
  ramp<std::uint8_t>(CV_8UC1).convertTo(deep, CV_16U, 16.0, 7.0);  // 12 bits of 16
  const cv::Mat image = normalised_image(deep);
  const cv::Mat expected = normalised_image(ramp<std::uint8_t>(CV_8UC1));
  EXPECT_LT(cv::norm(image, expected, cv::NORM_INF), kStretchRounding);
}

TEST(NormalisedImage, AHotPixelDoesNotFlattenTheRest) {
  cv::Mat raw = ramp<std::uint16_t>(CV_16UC1);
  raw.at<std::uint16_t>(3, 3) = 65535;
  const cv::Mat image = normalised_image(raw);
  EXPECT_EQ(image.at<float>(3, 3), 1.0F);
  // the middle 99 % is 99 wide; a quarter of it is left free above
  EXPECT_GT(image.at<float>(50, 99), 0.75F);
}

TEST(NormalisedImage, StretchesEachBandAndMakesAConstantOneZero) {
  const cv::Mat band = ramp<std::uint8_t>(CV_8UC1);
  const cv::Mat constant(100, 100, CV_8UC1, cv::Scalar(200));
  cv::Mat raw;
  cv::merge(std::vector<cv::Mat>{band, constant, 0.5 * band, band}, raw);
  const cv::Mat image = normalised_image(raw);
  ASSERT_EQ(image.type(), CV_32FC4);
  EXPECT_EQ(image.at<cv::Vec4f>(50, 99)[0], 1.0F);
  EXPECT_EQ(image.at<cv::Vec4f>(50, 99)[1], 0.0F);
  EXPECT_EQ(image.at<cv::Vec4f>(50, 99)[2], 1.0F);
}

TEST(NormalisedImage, KeepsARareValueOfAnOtherwiseConstantImage) {
  cv::Mat raw(100, 100, CV_8UC1, cv::Scalar(10));
  raw.at<std::uint8_t>(5, 5) = 20;
  const cv::Mat image = normalised_image(raw);
  EXPECT_EQ(image.at<float>(5, 5), 1.0F);
  EXPECT_EQ(image.at<float>(6, 6), 0.0F);
}

TEST(NormalisedImage, RejectsOtherTypes) {
  EXPECT_THROW(normalised_image(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(normalised_image(cv::Mat(4, 4, CV_32FC1, cv::Scalar(0))), std::invalid_argument);
  EXPECT_THROW(normalised_image(cv::Mat(4, 4, CV_8UC(5), cv::Scalar::all(0))),
               std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
