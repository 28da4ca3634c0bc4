// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/colour_diffusion.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

constexpr float kLambda = 0.05F;

cv::Mat lambda_of(const cv::Mat& image) { return {image.size(), CV_32FC1, cv::Scalar(kLambda)}; }

cv::Mat noise(int bands, double sigma) {
  cv::Mat image(64, 64, CV_32FC(bands));
  cv::RNG random(3);
  random.fill(image, cv::RNG::NORMAL, 0.0, sigma);
  return image;
}

double deviation(const cv::Mat& image) {
  cv::Scalar mean;
  cv::Scalar sigma;
  cv::meanStdDev(image, mean, sigma);
  return sigma[0];
}

/// Every band steps by its height in column 32.
cv::Mat step_image(const cv::Scalar& height) {
  cv::Mat image(64, 64, CV_32FC3, cv::Scalar::all(0));
  image.colRange(32, 64).setTo(height);
  return image;
}

TEST(ColourDiffusion, RemovesMostOfWeakNoise) {
  const cv::Mat image = noise(3, 0.01);
  EXPECT_LT(deviation(colour_diffusion(image, lambda_of(image), 3)), 0.4 * deviation(image));
}

TEST(ColourDiffusion, KeepsTheSumOfEveryBand) {
  const cv::Mat image = noise(3, 0.02);
  const cv::Scalar before = cv::sum(image);
  const cv::Scalar after = cv::sum(colour_diffusion(image, lambda_of(image), 3));
  constexpr double kRounding = 1e-3;  // rounding of 4096 float values
  for (int band = 0; band < 3; ++band) EXPECT_NEAR(before[band], after[band], kRounding);
}

TEST(ColourDiffusion, LeavesAStrongStepExactlyAsItIs) {
  const cv::Mat image = step_image(cv::Scalar::all(1.0));
  EXPECT_EQ(cv::norm(colour_diffusion(image, lambda_of(image), 3), image, cv::NORM_INF), 0.0);
}

TEST(ColourDiffusion, AStrongStepOfOneBandProtectsAWeakOneOfAnother) {
  const cv::Mat alone = step_image({0.02, 0.0, 0.0});
  const cv::Mat beside = step_image({0.02, 0.0, 1.0});
  const cv::Mat lambda = lambda_of(alone);
  const auto step = [](const cv::Mat& m) {
    return m.at<cv::Vec3f>(20, 32)[0] - m.at<cv::Vec3f>(20, 31)[0];
  };
  EXPECT_LT(step(colour_diffusion(alone, lambda, 3)), 0.01F);
  EXPECT_EQ(step(colour_diffusion(beside, lambda, 3)), 0.02F);
}

TEST(ColourDiffusion, DependsOnNothingBeyondItsReach) {
  const int reach = diffusion_reach_px(3);
  cv::Mat image = noise(1, 0.02);
  const cv::Mat before = colour_diffusion(image, lambda_of(image), 3);
  image.at<float>(32, 0) = 5.0F;
  const cv::Mat after = colour_diffusion(image, lambda_of(image), 3);
  const auto beyond = cv::Range(reach + 1, 64);
  EXPECT_EQ(cv::norm(before.colRange(beyond), after.colRange(beyond)), 0.0);
}

TEST(ColourDiffusion, TakesAnImageOfOnePixel) {
  const cv::Mat image(1, 1, CV_32FC2, cv::Scalar(0.25, 0.5));
  EXPECT_EQ(cv::norm(colour_diffusion(image, lambda_of(image), 2), image), 0.0);
}

TEST(ColourDiffusion, RejectsLevelsThatItDoesNotHave) {
  const cv::Mat image = noise(1, 0.02);
  EXPECT_THROW(colour_diffusion(image, lambda_of(image), 0), std::invalid_argument);
  EXPECT_THROW(colour_diffusion(image, lambda_of(image), 4), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
