// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plan_hull.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kHullTol = 1e-12;

std::vector<ZonePoint> points_at(const std::vector<Eigen::Vector2d>& st) {
  std::vector<ZonePoint> points;
  for (const Eigen::Vector2d& p : st) points.push_back({{p.x(), p.y(), 0.0}, p.x(), p.y(), 0});
  return points;
}

TEST(PlanHull, ContainsItsInsideAndBorder) {
  const PlanHull hull(points_at({{0, 0}, {4, 0}, {4, 2}, {0, 2}, {1, 1}}));
  EXPECT_TRUE(hull.contains({2, 1}));
  EXPECT_TRUE(hull.contains({4, 1}));
  EXPECT_FALSE(hull.contains({4.001, 1}));
  EXPECT_NEAR(hull.distance_to({7, 6}), 5.0, kHullTol);
  EXPECT_NEAR(hull.distance_to({2, -3}), 3.0, kHullTol);
  EXPECT_EQ(hull.distance_to({2, 1}), 0.0);
}

TEST(ConvexHull, HasItsCornersCounterClockwiseFromTheLeastX) {
  const std::vector<Eigen::Vector2d> corners =
      convex_hull({{4, 2}, {1, 1}, {0, 2}, {4, 0}, {2, 0}, {0, 0}});
  const std::vector<Eigen::Vector2d> expected{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  EXPECT_EQ(corners, expected);
  EXPECT_EQ(convex_hull({{0, 0}, {2, 2}, {1, 1}}).size(), 2U);
  EXPECT_EQ(convex_hull({{3, 1}, {3, 1}}).size(), 1U);
  EXPECT_TRUE(convex_hull({}).empty());
}

TEST(PlanHull, TakesDegenerateSets) {
  EXPECT_EQ(PlanHull(points_at({})).distance_to({0, 0}), HUGE_VAL);
  EXPECT_NEAR(PlanHull(points_at({{3, 4}})).distance_to({0, 0}), 5.0, kHullTol);
  const PlanHull segment(points_at({{0, 1}, {2, 1}, {1, 1}}));
  EXPECT_FALSE(segment.contains({1, 1}));
  EXPECT_NEAR(segment.distance_to({1, 3}), 2.0, kHullTol);
}

TEST(PlanHull, ContainsEveryPointOfItsSet) {
  test::Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Eigen::Vector2d> points(3 + trial);
    for (Eigen::Vector2d& p : points) p = random.vector(-5, 5).head<2>();
    const PlanHull hull(points_at(points));
    for (const Eigen::Vector2d& p : points) EXPECT_NEAR(hull.distance_to(p), 0.0, kHullTol);
    EXPECT_GT(hull.distance_to({5.1, 0}), 0.0);
  }
}

}  // namespace
}  // namespace ridgeline::evaluate
