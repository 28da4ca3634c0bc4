// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/sensor.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <cstdint>

namespace ridgeline::simulate {
namespace {

cv::Mat even_light(float radiance, int size = 200) {
  return {size, size, CV_32FC4, cv::Scalar::all(static_cast<double>(radiance))};
}

SensorOptions exact_sensor() {
  SensorOptions options;
  options.radiometric_sigma = 0.0;
  options.read_noise_electrons = 0.0;
  options.full_well_electrons = 1e9;
  return options;
}

TEST(Expose, WithoutNoiseGivesTheToneOfTheRadiance) {
  SensorOptions options = exact_sensor();
  options.bits = 16;
  options.white_radiance = 0.5;
  options.gamma = 2.0;
  constexpr float kRadiance = 0.125F;
  EXPECT_NEAR(tone(kRadiance, 0, options, {}), 0.5, 1e-12);  // (0.125 / 0.5)^(1/2)
  const cv::Mat image = expose(even_light(kRadiance, 4), options, 0);
  // shot noise of 1e9 electrons: 3e-5 of the range, 2 numbers of 65535
  EXPECT_NEAR(image.at<cv::Vec3w>(1, 2)[0], 0.5 * 65535.0, 10.0);
}

TEST(Expose, HasShotAndReadNoise) {
  SensorOptions options;
  options.radiometric_sigma = 0.0;
  options.gamma = 1.0;
  options.bits = 16;
  options.white_radiance = 1.0;
  options.full_well_electrons = 1000.0;
  options.read_noise_electrons = 20.0;
  const cv::Mat image = expose(even_light(0.4F), options, 0);
  cv::Scalar mean;
  cv::Scalar sigma;
  cv::meanStdDev(image, mean, sigma);
  const double expected = std::sqrt(0.4 * 1000.0 + 20.0 * 20.0) / 1000.0;
  // 40,000 pixels: the standard deviation is known to 0.35 %, the mean to 1.4e-4; 5 sigma
  EXPECT_NEAR(sigma[0] / 65535.0, expected, 5 * 0.0035 * expected);
  EXPECT_NEAR(mean[0] / 65535.0, 0.4, 5 * 1.5e-4);
}

TEST(Expose, UsesTheWholeRangeOfSixteenBits) {
  SensorOptions options = exact_sensor();
  options.bits = 16;
  cv::Mat ramp(8, 4096, CV_32FC4);
  for (int row = 0; row < ramp.rows; ++row) {
    for (int column = 0; column < ramp.cols; ++column) {
      const auto value = static_cast<float>(options.white_radiance * column / 4095.0);
      ramp.at<cv::Vec4f>(row, column) = cv::Vec4f::all(value);
    }
  }
  const cv::Mat image = expose(ramp, options, 0);
  double low = 0.0;
  double high = 0.0;
  cv::minMaxLoc(image.reshape(1), &low, &high);
  EXPECT_EQ(high, 65535.0);
  EXPECT_LT(low, 100.0);
  EXPECT_NE(image.at<cv::Vec3w>(0, 2000)[0] % 257, 0);  // not 8 bits spread out
}

TEST(Expose, OrdersTheBandsAsNamed) {
  SensorOptions options = exact_sensor();
  const cv::Mat light(1, 1, CV_32FC4, cv::Scalar(0.1, 0.2, 0.3, 0.4));
  options.bands = "rgbn";
  const auto all = expose(light, options, 0).at<cv::Vec4b>(0, 0);
  EXPECT_LT(all[0], all[1]);
  EXPECT_LT(all[1], all[2]);
  options.bands = "cir";
  const auto infrared = expose(light, options, 0).at<cv::Vec3b>(0, 0);
  EXPECT_EQ(infrared, cv::Vec3b(all[3], all[0], all[1]));
  options.bands = "rgb";
  EXPECT_EQ(expose(light, options, 0).type(), CV_8UC3);
}

TEST(Expose, ViewsDifferAsDeclaredAndRepeatBySeed) {
  SensorOptions options;
  const cv::Mat light = even_light(0.2F, 40);
  const cv::Mat left = expose(light, options, 0);
  const cv::Mat right = expose(light, options, 1);
  for (std::size_t band = 0; band < 3; ++band) {
    const double ratio =
        cv::mean(right)[static_cast<int>(band)] / cv::mean(left)[static_cast<int>(band)];
    const double declared = tone(0.2, band, options, radiometry_of(options, 1)) /
                            tone(0.2, band, options, radiometry_of(options, 0));
    EXPECT_NEAR(ratio, declared, 0.005) << band;  // rounding to 8 bits and noise of 1600 pixels
  }
  const cv::Mat again = expose(light, options, 0);
  EXPECT_TRUE(std::equal(left.datastart, left.dataend, again.datastart));
  options.seed = 2;
  const cv::Mat other = expose(light, options, 0);
  EXPECT_FALSE(std::equal(left.datastart, left.dataend, other.datastart));
}

TEST(Expose, RefusesOtherDepthsAndBands) {
  SensorOptions options;
  options.bits = 12;
  EXPECT_THROW(expose(even_light(0.1F, 2), options, 0), std::invalid_argument);
  options = {};
  options.bands = "xyz";
  EXPECT_THROW(expose(even_light(0.1F, 2), options, 0), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::simulate
