// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_fit.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kFitExact = 1e-12;  // noise-free points at metre size

TEST(FitPlane, RecoversANoiseFreePlane) {
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Plane3 truth(random.vector(-1, 1).normalized(), random.uniform(-5, 5));
    std::vector<Eigen::Vector3d> points(20);
    for (Eigen::Vector3d& p : points) p = truth.projection(random.vector(-10, 10));
    const auto fit = fit_plane(points);
    ASSERT_TRUE(fit.has_value());
    const Plane3 expected = upward(truth);
    EXPECT_LT((fit->plane.normal() - expected.normal()).norm(), kFitExact * 10);
    EXPECT_NEAR(fit->plane.offset(), expected.offset(), kFitExact * 100);
    EXPECT_NEAR(fit->rms_m, 0.0, 1e-6);  // the root of rounding errors of squares of 10 m
  }
}

TEST(FitPlane, HasNoAnswerForTooFewPointsOrALine) {
  const std::vector<Eigen::Vector3d> three{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(fit_plane(three));
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 10; ++i) line.emplace_back(i, 2 * i, 3 * i);
  EXPECT_FALSE(fit_plane(line));
  const std::vector<Eigen::Vector3d> one(10, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(fit_plane(one));
}

TEST(SigmaAt, IsTheScatterOfRepeatedFits) {
  // the fitted plane's height at a point 3 m outside the points, over 2000 noisy samples
  test::Random random(7);
  const Eigen::Vector3d outside(6, 0, 0);
  constexpr int kTrials = 2000;
  constexpr double kSigma_m = 0.034;
  double squares = 0.0;
  double predicted = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Eigen::Vector3d> points(60);
    for (Eigen::Vector3d& p : points) {
      const double x = random.uniform(-3, 3);
      const double y = random.uniform(-1, 1);
      p = {x, y, random.normal(kSigma_m)};
    }
    const auto fit = fit_plane(points);
    ASSERT_TRUE(fit.has_value());
    const double d = fit->plane.signedDistance(outside);
    squares += d * d;
    predicted += fit->sigma_at(outside) * fit->sigma_at(outside);
  }
  // the ratio of two variances over 2000 trials has the standard deviation sqrt(2/2000) = 3 %
  EXPECT_NEAR(squares / predicted, 1.0, 0.12);
}

TEST(FitPlane, DoesNotDependOnWhereTheSceneLies) {
  test::Random random(9);
  const Eigen::Vector3d shift(513000, 5403000, 250);
  std::vector<Eigen::Vector3d> points(50);
  for (Eigen::Vector3d& p : points)
    p = {random.uniform(0, 9), random.uniform(0, 9), random.normal(1)};
  std::vector<Eigen::Vector3d> shifted;
  for (const Eigen::Vector3d& p : points) shifted.emplace_back(p + shift);
  const auto here = fit_plane(points);
  const auto there = fit_plane(shifted);
  ASSERT_TRUE(here && there);
  // coordinates of 5e6 m are rounded to 1e-9 m
  EXPECT_LT((here->plane.normal() - there->plane.normal()).norm(), 1e-8);
  EXPECT_NEAR(here->rms_m, there->rms_m, 1e-8);
}

}  // namespace
}  // namespace ridgeline::evaluate
