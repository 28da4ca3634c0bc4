// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/covered_share.h"
#include "evaluate/faces/plan_polygon.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace ridgeline::test {
namespace {

using evaluate::covered_share;
using evaluate::PlanPolygon;
using V2 = Eigen::Vector2d;
using V = Eigen::Vector3d;

/// A square of 10 m with a hole of 4 m in its middle.
PlanPolygon square_with_hole() {
  return PlanPolygon({{V(0, 0, 0), V(10, 0, 0), V(10, 10, 0), V(0, 10, 0)},
                      {V(3, 3, 0), V(7, 3, 0), V(7, 7, 0), V(3, 7, 0)}});
}

TEST(PlanPolygon, ContainsWhatIsInTheRingAndNotInItsHole) {
  const PlanPolygon polygon = square_with_hole();
  EXPECT_TRUE(polygon.contains(V2(1, 1)));
  EXPECT_TRUE(polygon.contains(V2(9, 5)));
  EXPECT_FALSE(polygon.contains(V2(5, 5)));
  EXPECT_FALSE(polygon.contains(V2(-1, 5)));
  EXPECT_FALSE(polygon.contains(V2(11, 3)));
  EXPECT_NEAR(polygon.area_m2(), 84.0, 1e-12);
  EXPECT_TRUE(polygon.centroid().isApprox(V2(5, 5)));
}

TEST(PlanPolygon, FindsTheNearestEdge) {
  const PlanPolygon polygon = square_with_hole();
  const PlanPolygon::Nearest beside = polygon.nearest(V2(4, -2));
  EXPECT_EQ(beside.edge, 0U);
  EXPECT_NEAR(beside.distance_m, 2.0, 1e-12);
  EXPECT_TRUE(beside.beside);
  const PlanPolygon::Nearest corner = polygon.nearest(V2(-3, -4));
  EXPECT_NEAR(corner.distance_m, 5.0, 1e-12);
  EXPECT_FALSE(corner.beside);
  EXPECT_EQ(polygon.nearest(V2(6.5, 5)).edge, 5U);
  EXPECT_NEAR(polygon.distance_m(V2(5, 4)), 1.0, 1e-12);  // in the hole
  EXPECT_EQ(polygon.distance_m(V2(2, 2)), 0.0);
}

TEST(PlanPolygon, LeavesOutEdgesWithoutLength) {
  const PlanPolygon wall({{V(0, 0, 0), V(4, 0, 0), V(4, 0, 3), V(0, 0, 3)}});
  EXPECT_EQ(wall.edges().size(), 2U);
  EXPECT_EQ(wall.area_m2(), 0.0);
  EXPECT_TRUE(wall.centroid().isApprox(V2(2, 0)));
}

TEST(CoveredShare, IsTheAreaOfTheCircles) {
  const PlanPolygon square({{V(0, 0, 0), V(10, 0, 0), V(10, 10, 0), V(0, 10, 0)}});
  const double circle = std::numbers::pi / 100.0;
  // places 0.5 m apart tell the area of a circle of 1 m to about 10 %
  EXPECT_NEAR(covered_share(square, std::vector{V2(5, 5)}, 1.0), circle, 0.1 * circle);
  EXPECT_NEAR(covered_share(square, std::vector{V2(5, 5), V2(5, 5)}, 1.0), circle, 0.1 * circle);
  EXPECT_NEAR(covered_share(square, std::vector{V2(0, 5)}, 1.0), 0.5 * circle, 0.1 * circle);
  EXPECT_EQ(covered_share(square, std::vector{V2(5, 5)}, 8.0), 1.0);
  EXPECT_EQ(covered_share(square, std::vector{V2(30, 5)}, 1.0), 0.0);
  EXPECT_EQ(covered_share(square, {}, 1.0), 0.0);
  EXPECT_THROW(covered_share(square, {}, 0.0), std::invalid_argument);
}

TEST(CoveredShare, TakesNoPlacesInAHole) {
  EXPECT_NEAR(covered_share(square_with_hole(), std::vector{V2(5, 5)}, 2.0), 0.0, 1e-12);
}

TEST(CoveredShare, StaysFastForAHugeFace) {
  const PlanPolygon huge({{V(0, 0, 0), V(9999, 0, 0), V(9999, 9999, 0), V(0, 9999, 0)}});
  EXPECT_LT(covered_share(huge, std::vector{V2(5, 5)}, 0.01), 1e-4);
}

}  // namespace
}  // namespace ridgeline::test
