// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/sensor.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

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

/// A sensor whose numbers, of 16 bits, are proportional to the radiance.
SensorOptions linear_sensor() {
  SensorOptions options = exact_sensor();
  options.bits = 16;
  options.gamma = 1.0;
  options.white_radiance = 1.0;
  return options;
}

/// Light on both sides of a vertical edge, which is spread by a Gaussian.
cv::Mat light_of_edge(double x_px, double sigma_px) {
  cv::Mat light(200, 120, CV_32FC4);
  for (int row = 0; row < light.rows; ++row) {
    for (int column = 0; column < light.cols; ++column) {
      const double share = 0.5 * std::erfc((x_px - column) / (std::sqrt(2.0) * sigma_px));
      light.at<cv::Vec4f>(row, column) = cv::Vec4f::all(static_cast<float>(0.2 + 0.6 * share));
    }
  }
  return light;
}

/// Place and variance of a vertical edge by the change of the first band within a reach.
struct MeasuredEdge {
  double x_px, variance_px2;
};
MeasuredEdge measured_edge(const cv::Mat& image, int near_px, int reach_px) {
  cv::Mat profile;
  cv::reduce(image, profile, 0, cv::REDUCE_AVG, CV_64F);
  double sum = 0.0;
  double sum_x = 0.0;
  double sum_xx = 0.0;
  for (int column = near_px - reach_px; column < near_px + reach_px; ++column) {
    const double change =
        profile.at<cv::Vec3d>(0, column + 1)[0] - profile.at<cv::Vec3d>(0, column)[0];
    const double x = column + 0.5;
    sum += change;
    sum_x += change * x;
    sum_xx += change * x * x;
  }
  const double x_px = sum_x / sum;
  return {x_px, sum_xx / sum - x_px * x_px};
}

TEST(Expose, AddsTheVarianceOfItsBlurToThatOfAnEdgeAndLeavesItsPlace) {
  constexpr double kEdge_px = 60.3;
  constexpr double kSigma_px = 0.8;
  SensorOptions options = linear_sensor();
  const cv::Mat light = light_of_edge(kEdge_px, kSigma_px);
  for (const double blur_px : {0.0, 0.3, 1.0, 2.5, 5.0}) {
    options.blur_px = blur_px;
    const int reach_px = static_cast<int>(4.0 * std::hypot(kSigma_px, blur_px)) + 3;
    const MeasuredEdge edge = measured_edge(expose(light, options, 0), 60, reach_px);
    // the difference of two pixels is a mean over a pixel, which adds 1/12 px^2
    const double expected_px2 = kSigma_px * kSigma_px + blur_px * blur_px + 1.0 / 12.0;
    EXPECT_NEAR(edge.variance_px2, expected_px2, 0.02 + 0.01 * expected_px2) << blur_px;
    EXPECT_NEAR(edge.x_px, kEdge_px, 0.02) << blur_px;
  }
}

TEST(Expose, BlursTheLightAndNotTheNoise) {
  SensorOptions options;
  options.read_noise_electrons = 500.0;
  const cv::Mat sharp = expose(even_light(0.2F), options, 0);
  options.blur_px = 3.0;
  // even light is blurred to itself, but for float's rounding
  EXPECT_LE(cv::norm(expose(even_light(0.2F), options, 0), sharp, cv::NORM_INF), 1.0);
}

/// Light that rises along rows and columns, in each band in another way.
cv::Mat slopes() {
  cv::Mat light(40, 50, CV_32FC4);
  for (int row = 0; row < light.rows; ++row) {
    for (int column = 0; column < light.cols; ++column) {
      light.at<cv::Vec4f>(row, column) = {0.1F + 0.01F * static_cast<float>(column),
                                          0.9F - 0.01F * static_cast<float>(row),
                                          0.2F + 0.006F * static_cast<float>(row + column), 0.0F};
    }
  }
  return light;
}

TEST(Expose, BayerPatternLeavesGreyAndSlopesOfColourWhereTheyAre) {
  SensorOptions options = linear_sensor();
  for (const cv::Mat& light : {even_light(0.37F, 40), slopes()}) {
    options.bayer = false;
    const cv::Mat plain = expose(light, options, 0);
    options.bayer = true;
    const cv::Mat seen = expose(light, options, 0);
    const cv::Rect inner(1, 1, light.cols - 2, light.rows - 2);
    // shot noise of 1e9 electrons: 2 numbers of 65535; a pixel further a slope has 400 or more
    EXPECT_LE(cv::norm(seen(inner), plain(inner), cv::NORM_INF), 20.0);
  }
}

TEST(Expose, BayerPatternKeepsRedInEvenRowsAndColumnsOfTheImageAndBlueInOddOnes) {
  SensorOptions options;
  options.read_noise_electrons = 1000.0;  // so that no pixel is like its neighbours
  const cv::Mat light = even_light(0.2F, 40);
  const cv::Mat plain = expose(light, options, 0, 4);
  const cv::Mat plain_odd = expose(light, options, 0, 5);
  options.bayer = true;
  const cv::Mat seen = expose(light, options, 0, 4);
  const cv::Mat seen_odd = expose(light, options, 0, 5);
  int n_others = 0;
  for (int row = 1; row < 39; ++row) {
    for (int column = 1; column < 39; ++column) {
      const int own = row % 2 + column % 2;
      const int own_odd = (row + 1) % 2 + column % 2;
      const auto& pixel = seen.at<cv::Vec3b>(row, column);
      EXPECT_EQ(pixel[own], plain.at<cv::Vec3b>(row, column)[own]);
      EXPECT_EQ(seen_odd.at<cv::Vec3b>(row, column)[own_odd],
                plain_odd.at<cv::Vec3b>(row, column)[own_odd]);
      const int other = (own + 1) % 3;
      n_others += pixel[other] != plain.at<cv::Vec3b>(row, column)[other] ? 1 : 0;
    }
  }
  EXPECT_GT(n_others, 1000);  // of 1444: they come from other pixels
}

TEST(Expose, JpegChangesLittleAtHighQualityAndMoreAtLow) {
  SensorOptions options;
  const cv::Mat light = light_of_edge(60.0, 0.8);
  const cv::Mat plain = expose(light, options, 0);
  const auto rms = [&](int quality) {
    options.jpeg_quality = quality;
    const cv::Mat image = expose(light, options, 0);
    EXPECT_EQ(image.type(), CV_8UC3);
    return cv::norm(image, plain) / std::sqrt(static_cast<double>(plain.total() * 3));
  };
  const double high = rms(95);
  const double low = rms(10);
  EXPECT_GT(high, 0.0);
  EXPECT_LT(high, 3.0);
  EXPECT_GT(low, 1.5 * high);
}

TEST(Expose, JpegLeavesTheColours) {
  SensorOptions options = exact_sensor();
  const cv::Mat light(32, 32, CV_32FC4, cv::Scalar(0.3, 0.15, 0.05, 0.0));
  const cv::Mat plain = expose(light, options, 0);
  options.jpeg_quality = 95;
  EXPECT_LE(cv::norm(expose(light, options, 0), plain, cv::NORM_INF), 3.0);
}

TEST(Expose, RefusesOtherDepthsAndBands) {
  SensorOptions options;
  options.bits = 12;
  EXPECT_THROW(expose(even_light(0.1F, 2), options, 0), std::invalid_argument);
  options = {};
  options.bands = "xyz";
  EXPECT_THROW(expose(even_light(0.1F, 2), options, 0), std::invalid_argument);
}

TEST(Expose, RefusesBlurPatternAndJpegOfOtherImages) {
  const std::vector<SensorOptions> wrong{
      {.blur_px = -1.0},
      {.blur_px = std::numeric_limits<double>::quiet_NaN()},
      {.jpeg_quality = 101},
      {.bits = 16, .jpeg_quality = 90},
      {.bands = "rgbn", .jpeg_quality = 90},
      {.bands = "cir", .bayer = true},
  };
  for (const SensorOptions& options : wrong) {
    EXPECT_THROW(expose(even_light(0.1F, 2), options, 0), std::invalid_argument);
  }
}

}  // namespace
}  // namespace ridgeline::simulate
