// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/plan_geometry.h"

#include "apps/simulate/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline::simulate {
namespace {

constexpr double kTol = 1e-12;  // coordinates below 20, one or two products each

const ConvexPolygon kSquare = rectangle({0.0, 0.0}, {2.0, 2.0});

TEST(PlaneOf, LiesAtItsHeightWithUnitNormalUpwards) {
  const PlanFunction height{{0.5, -0.25}, 3.0};
  const Plane3 plane = plane_of(height);
  EXPECT_NEAR(plane.normal().norm(), 1.0, kTol);
  EXPECT_GT(plane.normal().z(), 0.0);
  EXPECT_NEAR(plane.signedDistance(Eigen::Vector3d(4.0, 2.0, 4.5)), 0.0, kTol);
}

TEST(HalfPlanes, GiveDistancesFromTheSidesPositiveInside) {
  const std::vector<PlanFunction> sides = half_planes(kSquare);
  ASSERT_EQ(sides.size(), 4U);
  const Eigen::Vector2d x(0.5, 0.25);
  EXPECT_NEAR(sides[0](x), 0.25, kTol);
  EXPECT_NEAR(sides[1](x), 1.5, kTol);
  EXPECT_NEAR(sides[2](x), 1.75, kTol);
  EXPECT_NEAR(sides[3](x), 0.5, kTol);
}

TEST(Contains, CountsTheBorderAsInside) {
  EXPECT_TRUE(contains(kSquare, {1.0, 1.0}));
  EXPECT_TRUE(contains(kSquare, {2.0, 2.0}));
  EXPECT_FALSE(contains(kSquare, {2.1, 1.0}));
  EXPECT_FALSE(contains(kSquare, {1.0, -0.1}));
}

TEST(Overlap, TouchingPolygonsDoNotOverlap) {
  EXPECT_FALSE(overlap(kSquare, rectangle({2.0, 0.0}, {3.0, 2.0})));
  EXPECT_TRUE(overlap(kSquare, rectangle({1.9, 0.0}, {3.0, 2.0})));
  EXPECT_TRUE(overlap(kSquare, rectangle({0.5, 0.5}, {1.5, 1.5})));  // contained
  // boxes overlap in x and in y, but a diagonal side separates them
  const ConvexPolygon corner{{2.1, 1.0}, {3.0, 2.0}, {2.1, 3.0}, {1.0, 2.1}};
  EXPECT_TRUE(overlap(kSquare, rectangle({1.0, 1.0}, {3.0, 3.0})));
  const ConvexPolygon beyond{{3.1, 1.0}, {3.1, 3.1}, {1.0, 3.1}};
  EXPECT_FALSE(overlap(kSquare, beyond));
  EXPECT_FALSE(overlap(beyond, kSquare));
}

TEST(ClipPolygon, KeepsLabelsAndNamesTheNewSide) {
  const LabelledPolygon square{kSquare, {10, 11, 12, 13}};
  const LabelledPolygon left = clip(square, {{-1.0, 0.0}, 0.5}, 99);  // x <= 0.5
  ASSERT_EQ(left.corners.size(), 4U);
  EXPECT_NEAR(area(left.corners), 1.0, kTol);
  EXPECT_EQ(left.labels, (std::vector<int>{10, 99, 12, 13}));
}

TEST(ClipPolygon, ThroughACornerReplacesNoOtherSide) {
  const LabelledPolygon square{kSquare, {10, 11, 12, 13}};
  const LabelledPolygon triangle = clip(square, {{-1.0, 1.0}, 0.0}, 99);  // y >= x
  ASSERT_EQ(triangle.corners.size(), 3U);
  EXPECT_EQ(triangle.labels, (std::vector<int>{99, 12, 13}));
}

TEST(ClipPolygon, NothingLeftIsEmpty) {
  const LabelledPolygon square{kSquare, {0, 1, 2, 3}};
  EXPECT_TRUE(clip(square, {{1.0, 0.0}, -2.0}, 9).corners.empty());  // only the side x = 2
  EXPECT_TRUE(clip(square, {{1.0, 0.0}, -5.0}, 9).corners.empty());
}

TEST(ClipInterval, KeepsThePartInsideInEitherDirection) {
  const PlanFunction right{{1.0, 0.0}, -1.0};  // x >= 1
  const PlanInterval forward = clip({}, {{0.0, 0.0}, {4.0, 0.0}}, right);
  EXPECT_NEAR(forward.begin, 0.25, kTol);
  EXPECT_EQ(forward.end, 1.0);
  const PlanInterval backward = clip({}, {{4.0, 0.0}, {0.0, 0.0}}, right);
  EXPECT_EQ(backward.begin, 0.0);
  EXPECT_NEAR(backward.end, 0.75, kTol);
}

TEST(ClipInterval, ParallelSegmentIsAllOrNothing) {
  const PlanFunction right{{1.0, 0.0}, -1.0};
  EXPECT_FALSE(clip({}, {{1.0, 0.0}, {1.0, 5.0}}, right).empty());
  EXPECT_TRUE(clip({}, {{0.9, 0.0}, {0.9, 5.0}}, right).empty());
}

TEST(Subtract, CutsMiddleEndsAndAll) {
  const std::vector<PlanInterval> whole{{0.0, 1.0}};
  const std::vector<PlanInterval> middle = subtract(whole, {0.25, 0.5});
  ASSERT_EQ(middle.size(), 2U);
  EXPECT_EQ(middle[0].end, 0.25);
  EXPECT_EQ(middle[1].begin, 0.5);
  EXPECT_EQ(subtract(whole, {-1.0, 0.25}).front().begin, 0.25);
  EXPECT_EQ(subtract(whole, {0.75, 2.0}).front().end, 0.75);
  EXPECT_TRUE(subtract(whole, {0.0, 1.0}).empty());
  EXPECT_EQ(subtract(whole, {0.5, 0.5}).size(), 1U);  // an empty hole cuts nothing
}

TEST(Intersection, OfTwoPlanesIsTheirCommonLineInBothPolygons) {
  const PlanFunction rising{{1.0, 0.0}, 0.0};
  const PlanFunction level{{0.0, 0.0}, 1.5};
  const auto line = intersection(rising, kSquare, level, rectangle({0.0, 0.5}, {9.0, 9.0}));
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->start.x(), 1.5, 1e-9);
  EXPECT_NEAR(line->end.x(), 1.5, 1e-9);
  EXPECT_NEAR(std::min(line->start.y(), line->end.y()), 0.5, 1e-9);
  EXPECT_NEAR(std::max(line->start.y(), line->end.y()), 2.0, 1e-9);
}

TEST(Intersection, IsNothingForParallelPlanesOrDisjointPolygons) {
  const PlanFunction rising{{1.0, 0.0}, 0.0};
  const PlanFunction level{{0.0, 0.0}, 1.5};
  EXPECT_FALSE(intersection(rising, kSquare, {{1.0, 0.0}, 1.0}, kSquare));
  EXPECT_FALSE(intersection(rising, kSquare, level, rectangle({5.0, 5.0}, {6.0, 6.0})));
  EXPECT_FALSE(intersection(rising, kSquare, level, {}));
}

TEST(Intersection, LiesOnBothPlanesForRandomPlanes) {
  Random random({11});
  int found = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto plane = [&]() -> PlanFunction {
      return {{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)}, random.uniform(-1.0, 1.0)};
    };
    const PlanFunction a = plane();
    const PlanFunction b = plane();
    const auto line = intersection(a, kSquare, b, kSquare);
    if (!line) continue;
    ++found;
    for (const Eigen::Vector2d& x : {line->start, line->end}) EXPECT_NEAR(a(x), b(x), 1e-9);
  }
  EXPECT_GT(found, 200);
}

}  // namespace
}  // namespace ridgeline::simulate
