// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/regression_line.h"

#include "tests/support/random.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kFitRounding = 1e-10;

/// Points one pixel apart on the line y = 0.5 x + 3, moved across it by noise that is correlated
/// like the gradient of a smoothed image.
Points noisy_points(int n, double sigma_px, bool correlated, test::Random& random) {
  const Eigen::Vector2d u = Eigen::Vector2d(2.0, 1.0).normalized();
  const Eigen::Vector2d normal(-u.y(), u.x());
  std::vector<double> white(n + 4);
  for (double& value : white) value = random.normal(sigma_px);
  Points points;
  for (int i = 0; i < n; ++i) {
    // binomial weights 1 4 6 4 1, of sum of squares 70
    const double smooth =
        (white[i] + 4 * white[i + 1] + 6 * white[i + 2] + 4 * white[i + 3] + white[i + 4]) /
        std::sqrt(70.0);
    points.push_back(Eigen::Vector2d(0.0, 3.0) + i * u + (correlated ? smooth : white[i]) * normal);
  }
  return points;
}

/// Mean squares of the errors at the centroid and of the direction over their stated sigmas.
Eigen::Vector2d mean_squared_errors(int n, bool correlated) {
  constexpr int kLines = 2000;
  test::Random random(11);
  std::vector<RegressionLine> lines;
  for (int i = 0; i < kLines; ++i) {
    lines.push_back(regression_line(noisy_points(n, 0.2, correlated, random)));
  }
  const EdgeNoise noise = edge_noise(lines);
  const Eigen::Vector2d u = Eigen::Vector2d(2.0, 1.0).normalized();
  const Eigen::Vector2d normal(-u.y(), u.x());
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const RegressionLine& line : lines) {
    const UncertainSegment2 s = uncertain_segment(line, noise, {});
    const double across = normal.dot(s.centroid_px - Eigen::Vector2d(0.0, 3.0));
    const double angle = std::asin(normal.dot(line.along));
    sum +=
        Eigen::Vector2d(std::pow(across / s.sigma_q_px, 2), std::pow(angle / s.sigma_phi_rad, 2));
  }
  return sum / kLines;
}

TEST(RegressionLine, OfExactPointsIsTheirLine) {
  Points points;
  for (int i = 0; i < 20; ++i) points.emplace_back(10.0 - 0.6 * i, 4.0 + 0.8 * i);
  const RegressionLine line = regression_line(points);
  EXPECT_NEAR((line.along - Eigen::Vector2d(-0.6, 0.8)).norm(), 0.0, kFitRounding);
  EXPECT_NEAR(line.last - line.first, 19.0, kFitRounding);
  EXPECT_NEAR(line.rms_px, 0.0, kFitRounding);
}

TEST(RegressionLine, HardlyFollowsAnOutlier) {
  test::Random random(4);
  Points points = noisy_points(60, 0.05, false, random);
  const RegressionLine before = regression_line(points);
  points[30].y() += 1.0;
  const RegressionLine after = regression_line(points);
  const Eigen::Vector2d normal(-before.along.y(), before.along.x());
  // a mean would move by 0.9 / 60 = 0.015 px
  EXPECT_LT(std::abs(normal.dot(after.centroid - before.centroid)), 0.003);
}

TEST(RegressionLine, DoesNotFollowTheBendNextToACorner) {
  Points points;
  for (int i = 0; i < 40; ++i) points.emplace_back(i, 0.0);
  points[0].y() = points[39].y() = 0.8;
  points[1].y() = points[38].y() = 0.3;
  const RegressionLine line = regression_line(points);
  EXPECT_NEAR(line.centroid.y(), 0.0, kFitRounding);
  EXPECT_NEAR(line.last - line.first, 39.0, kFitRounding);
}

TEST(RegressionLine, NeedsThreePoints) {
  const Points points{{0, 0}, {1, 0}};
  EXPECT_THROW(regression_line(points), std::invalid_argument);
}

// Mean of 2000 squares of normal errors: 1 +- 0.032; Huber's weights and the estimated correlation
// cost some of it.
constexpr double kMeanSquare = 0.15;

TEST(UncertainSegment, ErrorsOfIndependentPointsAreAsStated) {
  const Eigen::Vector2d errors = mean_squared_errors(50, false);
  EXPECT_NEAR(errors[0], 1.0, kMeanSquare);
  EXPECT_NEAR(errors[1], 1.0, kMeanSquare);
}

TEST(UncertainSegment, ErrorsOfCorrelatedPointsAreAsStated) {
  const Eigen::Vector2d errors = mean_squared_errors(50, true);
  EXPECT_NEAR(errors[0], 1.0, kMeanSquare);
  EXPECT_NEAR(errors[1], 1.0, kMeanSquare);
}

TEST(EdgeNoise, FindsTheCorrelationOfNeighbours) {
  test::Random random(9);
  std::vector<RegressionLine> white;
  std::vector<RegressionLine> smooth;
  for (int i = 0; i < 300; ++i) {
    white.push_back(regression_line(noisy_points(60, 0.2, false, random)));
    smooth.push_back(regression_line(noisy_points(60, 0.2, true, random)));
  }
  EXPECT_NEAR(edge_noise(white).correlation, 1.0, 0.15);
  // (1 + 4 + 6 + 4 + 1)^2 / 70
  EXPECT_NEAR(edge_noise(smooth).correlation, 256.0 / 70.0, 0.35);
}

TEST(EdgeNoise, OfAnImageWithoutLongLinesIsTypical) {
  EXPECT_GT(edge_noise({}).variance_px2, 0.0);
  EXPECT_GT(edge_noise({}).correlation, 1.0);
}

TEST(EdgeNoise, OfLinesThatFitExactlyIsNoneAndUncorrelated) {
  Points points;
  for (int i = 0; i < 60; ++i) points.emplace_back(i, 7.0);
  const std::vector<RegressionLine> lines(3, regression_line(points));
  ASSERT_EQ(lines[0].rms_px, 0.0);  // rows and columns of an image without noise give this
  const EdgeNoise noise = edge_noise(lines);
  EXPECT_EQ(noise.correlation, 1.0);
  EXPECT_EQ(noise.variance_px2, 0.0);
}

TEST(UncertainSegment, AShortLineOfLuckyPointsIsNotExact) {
  Points points;
  for (int i = 0; i < 10; ++i) points.emplace_back(i, 0.0);
  const UncertainSegment2 s = uncertain_segment(regression_line(points), {0.04, 2.0}, {});
  EXPECT_GT(s.sigma_q_px, 0.05);
}

TEST(UncertainSegment, OfLinesThatAllFitExactlyIsStillUncertain) {
  Points points;
  for (int i = 0; i <= 40; ++i) points.emplace_back(i, 0.0);
  const RegressionLine line = regression_line(points);
  const UncertainSegment2 s =
      uncertain_segment(line, edge_noise(std::vector(3, line)), SystematicError{0.0, 0.0});
  EXPECT_GT(s.sigma_q_px, 0.0);
  EXPECT_LT(s.sigma_q_px, 1e-3);
  EXPECT_GT(s.sigma_phi_rad, 0.0);
}

TEST(UncertainSegment, AddsTheSystematicParts) {
  Points points;
  for (int i = 0; i <= 40; ++i) points.emplace_back(i, 0.0);
  const RegressionLine line = regression_line(points);
  const UncertainSegment2 plain = uncertain_segment(line, {}, {});
  const UncertainSegment2 more = uncertain_segment(line, {}, {.across_px = 0.3, .ends_px = 0.2});
  EXPECT_NEAR(more.sigma_q_px, std::hypot(plain.sigma_q_px, 0.3), kFitRounding);
  EXPECT_NEAR(more.sigma_phi_rad, std::hypot(plain.sigma_phi_rad, 0.2 / 20.0), kFitRounding);
}

}  // namespace
}  // namespace ridgeline::reconstruct
