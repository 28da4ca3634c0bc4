// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/ridge_displacement.h"

#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::evaluate {
namespace {

constexpr double kShiftExact = 1e-12;
const std::array<double, 2> kSigmas_m{0.01, 0.02};

Plane3 through(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  return upward(Plane3(normal.normalized(), point));
}

/// Two roofs that meet in the line from `start` along `direction` and fall to both sides of it with
/// the slopes.
std::array<Plane3, 2> roofs(const Eigen::Vector3d& start,
                            const Eigen::Vector3d& direction,
                            double left_slope,
                            double right_slope) {
  const Eigen::Vector3d left = Eigen::Vector3d(-direction.y(), direction.x(), 0.0).normalized();
  const Eigen::Vector3d down_left = left - left_slope * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d down_right = -left - right_slope * Eigen::Vector3d::UnitZ();
  return {through(start, direction.cross(down_left)), through(start, direction.cross(down_right))};
}

Segment3 shifted(const Segment3& line, const Eigen::Vector3d& by) {
  return {line.start + by, line.end + by};
}

TEST(RidgeDisplacement, OfALevelRidgeIsItsMovementAcrossAndUp) {
  const Segment3 ridge{{2, 3, 9}, {12, 3, 9}};
  const auto planes = roofs(ridge.start, {1, 0, 0}, 0.5, 0.9);
  const auto d = ridge_displacement(shifted(ridge, {0.7, 0.2, 0.4}), planes, kSigmas_m);
  ASSERT_TRUE(d);
  EXPECT_NEAR(d->horizontal_m, 0.2, kShiftExact);
  EXPECT_NEAR(d->vertical_m, 0.4, kShiftExact);
}

TEST(RidgeDisplacement, DoesNotDependOnTheEndThatTheLineBeginsWith) {
  const Segment3 ridge{{2, 3, 9}, {7, -4, 9}};
  const auto planes = roofs(ridge.start, ridge.end - ridge.start, 0.5, 0.5);
  const Segment3 line = shifted(ridge, {0.3, 0.1, -0.2});
  const auto there = ridge_displacement(line, planes, kSigmas_m);
  const auto back = ridge_displacement({line.end, line.start}, planes, kSigmas_m);
  ASSERT_TRUE(there && back);
  EXPECT_NEAR(there->horizontal_m, back->horizontal_m, kShiftExact);
  EXPECT_NEAR(there->vertical_m, back->vertical_m, kShiftExact);
  // the line was moved to the side of larger x
  EXPECT_GT(there->horizontal_m, 0.0);
}

TEST(RidgeDisplacement, OfAHipIsTheDifferenceOfHeightsAtTheSamePlaceInPlan) {
  const Eigen::Vector3d along(3, 4, 2.5);  // 5 m in plan rise by 2.5 m
  const Segment3 hip{{0, 0, 5}, along + Eigen::Vector3d(0, 0, 5)};
  const auto planes = roofs(hip.start, along, 0.6, 0.6);
  const Eigen::Vector3d movement(0.5, -0.1, 0.3);
  const auto d = ridge_displacement(shifted(hip, movement), planes, kSigmas_m);
  ASSERT_TRUE(d);
  const Eigen::Vector3d u(0.6, 0.8, 0.0);
  const Eigen::Vector3d h(0.8, -0.6, 0.0);
  EXPECT_NEAR(d->horizontal_m, movement.dot(h), kShiftExact);
  EXPECT_NEAR(d->vertical_m, movement.z() - movement.dot(u) * 0.5, kShiftExact);

  const auto along_itself = ridge_displacement(shifted(hip, 0.2 * along), planes, kSigmas_m);
  ASSERT_TRUE(along_itself);
  EXPECT_NEAR(along_itself->horizontal_m, 0.0, kShiftExact);
  EXPECT_NEAR(along_itself->vertical_m, 0.0, kShiftExact);
}

TEST(RidgeDisplacement, HasTheCovarianceOfPlanesThatAreFittedAgain) {
  test::Random random(4);
  const Segment3 ridge{{0, 0, 9}, {10, 0, 9}};
  const auto planes = roofs(ridge.start, {1, 0, 0}, 0.4, 0.8);
  const auto d = ridge_displacement(ridge, planes, kSigmas_m);
  ASSERT_TRUE(d);
  constexpr int kTrials = 20000;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    auto fitted = planes;
    for (std::size_t i = 0; i < 2; ++i) fitted[i].offset() += random.normal(kSigmas_m[i]);
    const auto again = ridge_displacement(ridge, fitted, kSigmas_m);
    ASSERT_TRUE(again);
    const Eigen::Vector2d e(again->horizontal_m, again->vertical_m);
    scatter += e * e.transpose() / kTrials;
  }
  // a variance over 20,000 trials is known to 1 %
  const Eigen::Matrix2d ratio = scatter.cwiseQuotient(d->covariance_m2);
  EXPECT_LT((ratio.array() - 1.0).abs().maxCoeff(), 0.06) << scatter << "\n" << d->covariance_m2;
}

TEST(RidgeDisplacement, IsNotToldByPlanesThatAreNearlyOne) {
  const Segment3 ridge{{0, 0, 9}, {10, 0, 9}};
  const auto displacement = [&](double half_angle_deg) {
    const double slope = std::tan(half_angle_deg * M_PI / 180.0);
    return ridge_displacement(ridge, roofs(ridge.start, {1, 0, 0}, slope, slope), kSigmas_m);
  };
  EXPECT_FALSE(displacement(0.5 * kMinRidgeAngle_deg - 0.01));
  EXPECT_TRUE(displacement(0.5 * kMinRidgeAngle_deg + 0.01));
}

TEST(RidgeDisplacement, IsNotToldOfAVerticalLine) {
  const auto planes = roofs({0, 0, 9}, {1, 0, 0}, 0.5, 0.5);
  EXPECT_FALSE(ridge_displacement({{0, 0, 1}, {0, 0, 4}}, planes, kSigmas_m));
}

}  // namespace
}  // namespace ridgeline::evaluate
