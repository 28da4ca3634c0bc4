// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/alpha_shape.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// Random points of a square of 20 m with a hole of 6 m in its middle.
std::vector<Eigen::Vector2d> square_with_hole() {
  test::Random random(5);
  std::vector<Eigen::Vector2d> points;
  while (points.size() < 4000) {
    const Eigen::Vector2d x(random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0));
    if (x.cwiseAbs().maxCoeff() > 3.0) points.push_back(x);
  }
  return points;
}

double enclosed_m2(const std::vector<std::size_t>& loop,
                   const std::vector<Eigen::Vector2d>& points) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d a = points[loop[i]], b = points[loop[(i + 1) % loop.size()]];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

TEST(AlphaShape, CoversTheAreaOfItsPoints) {
  const std::vector<Eigen::Vector2d> points = square_with_hole();
  constexpr double kArea_m2 = 364.0;
  // the border of random points lies about half a spacing (0.15 m) inside, on 104 m of border
  constexpr double kLost_m2 = 16.0, kTolerance_m2 = 6.0;
  EXPECT_NEAR(alpha_shape(points).area_m2, kArea_m2 - kLost_m2, kTolerance_m2);
}

TEST(AlphaShape, HasAnOuterBorderAndHolesInOppositeDirections) {
  const std::vector<Eigen::Vector2d> points = square_with_hole();
  const AlphaShape shape = alpha_shape(points);
  std::vector<double> areas_m2;
  for (const auto& loop : shape.loops) areas_m2.push_back(enclosed_m2(loop, points));
  std::ranges::sort(areas_m2);
  ASSERT_GE(areas_m2.size(), 2U);
  EXPECT_LT(areas_m2.front(), -36.0);  // the hole, a little larger than without points
  EXPECT_GT(areas_m2.back(), 370.0);
  EXPECT_NEAR(std::accumulate(areas_m2.begin(), areas_m2.end(), 0.0), shape.area_m2, 1e-6);
}

TEST(AlphaShape, OfCollinearPointsIsEmpty) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 20; ++i) points.emplace_back(0.5 * i, 0.25 * i);
  EXPECT_TRUE(alpha_shape(points).loops.empty());
}

}  // namespace
}  // namespace ridgeline::evaluate
