// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/colour_boosting.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

/// Steps of brightness every 8 rows, one fainter step of hue in the middle column.
cv::Mat bright_steps_and_a_hue_step() {
  cv::Mat image(64, 64, CV_32FC3);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const float grey = y / 8 % 2 == 0 ? 0.3F : 0.6F;
      const float hue = x < 32 ? 0.05F : -0.05F;
      image.at<cv::Vec3f>(y, x) = {grey + hue, grey - hue, grey};
    }
  }
  return image;
}

double step(const cv::Mat& image, const cv::Point& a, const cv::Point& b) {
  return cv::norm(image.at<cv::Vec3f>(a) - image.at<cv::Vec3f>(b));
}

TEST(ColourBoosted, RaisesARareChangeOfHueAgainstBrightness) {
  const cv::Mat image = bright_steps_and_a_hue_step();
  const cv::Mat boosted = colour_boosted(image);
  const auto hue_to_brightness = [](const cv::Mat& m) {
    return step(m, {31, 4}, {32, 4}) / step(m, {10, 7}, {10, 8});
  };
  EXPECT_GT(hue_to_brightness(boosted), 2.0 * hue_to_brightness(image));
}

TEST(ColourBoosted, LeavesOneBandAndAConstantImageAsTheyAre) {
  const cv::Mat one(9, 9, CV_32FC1, cv::Scalar(0.4));
  EXPECT_EQ(cv::norm(colour_boosted(one), one), 0.0);
  const cv::Mat constant(9, 9, CV_32FC4, cv::Scalar::all(0.4));
  EXPECT_EQ(cv::norm(colour_boosted(constant), constant), 0.0);
}

}  // namespace
}  // namespace ridgeline::reconstruct
