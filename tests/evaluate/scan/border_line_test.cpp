// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/border_line.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kSigma_m = 0.034;

struct Scatter {
  double bias_m = 0.0, rms_m = 0.0, share_in_interval = 0.0;
};

/// Borders at t = 0 of random points, as the estimates show them.
Scatter of_random_points(double length_m, double points_per_m2, bool knows_slope) {
  constexpr int kTrials = 400;
  Scatter scatter;
  for (int trial = 0; trial < kTrials; ++trial) {
    test::Random random(100 + trial);
    std::vector<Eigen::Vector2d> points;
    const int n = static_cast<int>(std::lround(length_m * 3.0 * points_per_m2));
    for (int i = 0; i < n; ++i)
      points.emplace_back(random.uniform(0.0, length_m),
                          random.uniform(-3.0, 0.0) + random.normal(kSigma_m));
    const BorderLine line =
        border_line({.st_m = points,
                     .length_m = length_m,
                     .sigma_m = kSigma_m,
                     .usual_slope = knows_slope ? 0.0 : std::numeric_limits<double>::infinity(),
                     .usual_slope_sigma = 0.005});
    scatter.bias_m += line.offset_m / kTrials;
    scatter.rms_m += line.offset_m * line.offset_m / kTrials;
    if (std::abs(line.offset_m) <= 1.96 * std::sqrt(line.covariance(0, 0)))
      scatter.share_in_interval += 1.0 / kTrials;
  }
  scatter.rms_m = std::sqrt(scatter.rms_m);
  return scatter;
}

TEST(BorderLine, HasNoBiasAndATrueInterval) {
  for (const double length_m : {2.0, 4.0, 8.0, 12.0}) {
    const Scatter known = of_random_points(length_m, 5.0, true);
    // the gap to the outermost point is 1 / (density x length) plus noise; the mean of 400 trials
    // has a standard deviation of about 5 % of it
    const double gap_m = 1.0 / (5.0 * length_m);
    EXPECT_NEAR(known.bias_m, 0.0, 0.25 * gap_m + 0.1 * kSigma_m) << length_m;
    EXPECT_LE(known.rms_m, 1.25 * gap_m + kSigma_m) << length_m;
    EXPECT_GE(known.share_in_interval, 0.92) << length_m;
    EXPECT_LE(known.share_in_interval, 0.985) << length_m;
  }
}

TEST(BorderLine, IsLessAccurateWithoutAUsualDirection) {
  const Scatter known = of_random_points(4.0, 5.0, true), free = of_random_points(4.0, 5.0, false);
  EXPECT_GT(free.rms_m, known.rms_m);
  EXPECT_GE(free.share_in_interval, 0.92);
  EXPECT_LE(std::abs(free.bias_m), 0.05);
}

TEST(BorderLine, CountsScanLinesAsTheyLie) {
  // scan lines along the border at a distance of 0.9 m, with many points each: the border lies
  // anywhere between the last of them and the next
  constexpr int kTrials = 200;
  constexpr double kLines_m = 0.9;
  double bias_m = 0.0, share = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    test::Random random(trial);
    const double first_m = random.uniform(-kLines_m, 0.0);
    std::vector<Eigen::Vector2d> points;
    for (int row = 0; row < 4; ++row)
      for (int i = 0; i < 40; ++i)
        points.emplace_back(0.25 * i, first_m - kLines_m * row + random.normal(kSigma_m));
    const BorderLine line = border_line({.st_m = points,
                                         .length_m = 10.0,
                                         .sigma_m = kSigma_m,
                                         .usual_slope = 0.0,
                                         .usual_slope_sigma = 0.005});
    bias_m += line.offset_m / kTrials;
    if (std::abs(line.offset_m) <= 1.96 * std::sqrt(line.covariance(0, 0))) share += 1.0 / kTrials;
  }
  EXPECT_NEAR(bias_m, 0.0, 0.15 * kLines_m);
  EXPECT_GE(share, 0.9);
}

TEST(BorderLine, LeavesAnOutlierOutside) {
  constexpr double kTolerance_m = 0.15;  // the outlier would move it by 0.8 m
  std::vector<Eigen::Vector2d> points;
  test::Random random(2);
  for (int i = 0; i < 200; ++i)
    points.emplace_back(random.uniform(0.0, 10.0),
                        random.uniform(-3.0, 0.0) + random.normal(kSigma_m));
  points.emplace_back(5.0, 0.8);
  const BorderLine line = border_line({.st_m = points,
                                       .length_m = 10.0,
                                       .sigma_m = kSigma_m,
                                       .usual_slope = 0.0,
                                       .usual_slope_sigma = 0.005});
  EXPECT_LE(std::abs(line.offset_m), kTolerance_m);
}

}  // namespace
}  // namespace ridgeline::evaluate
