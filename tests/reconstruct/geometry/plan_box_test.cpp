// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/plan_box.h"

#include <gtest/gtest.h>

namespace ridgeline {
namespace {

/// A triangle with its right angle in the origin.
const std::vector<Eigen::Vector2d> kTriangle{{0.0, 0.0}, {4.0, 0.0}, {0.0, 4.0}};

Eigen::AlignedBox2d unit_box_at(double x, double y) {
  return {Eigen::Vector2d(x, y), Eigen::Vector2d(x + 1.0, y + 1.0)};
}

TEST(PlanBox, PointsOnTheBorderLieWithin) {
  EXPECT_TRUE(is_within(kTriangle, {1.0, 1.0}));
  EXPECT_TRUE(is_within(kTriangle, {2.0, 2.0}));
  EXPECT_FALSE(is_within(kTriangle, {2.1, 2.0}));
  EXPECT_FALSE(is_within(kTriangle, {-0.1, 1.0}));
  EXPECT_TRUE(is_within({}, {7.0, 7.0}));
}

TEST(PlanBox, BoxesThatTouchThePolygonAloneDoNotMeetIt) {
  EXPECT_TRUE(meets(kTriangle, unit_box_at(1.5, 1.5)));
  EXPECT_FALSE(meets(kTriangle, unit_box_at(2.0, 2.0)));
  EXPECT_FALSE(meets(kTriangle, unit_box_at(1.0, -1.0)));
  EXPECT_TRUE(meets(kTriangle, unit_box_at(1.0, -0.9)));
}

TEST(PlanBox, CornersGoRoundCounterClockwiseAndGiveTheBoxBack) {
  const Eigen::AlignedBox2d box = grown(unit_box_at(3.0, 5.0), 0.5);
  EXPECT_EQ(box.min(), Eigen::Vector2d(2.5, 4.5));
  const std::vector<Eigen::Vector2d> corners = corners_of(box);
  EXPECT_TRUE(box_around(corners).isApprox(box));
  EXPECT_TRUE(is_within(corners, box.center()));
}

}  // namespace
}  // namespace ridgeline
