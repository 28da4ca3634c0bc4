// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/plan_mask.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace ridgeline::io {
namespace {

TEST(PlanMask, HoldsThePointsNearASegmentAndFewElse) {
  const std::vector<Segment2> segments{{{0, 0}, {10, 0}}};
  const PlanMask mask(segments, 2.0);
  EXPECT_TRUE(mask.contains(5.0, 1.99));
  EXPECT_TRUE(mask.contains(-1.99, 0.0));
  EXPECT_FALSE(mask.contains(5.0, 5.0));
  EXPECT_FALSE(mask.contains(15.0, 0.0));
  EXPECT_FALSE(mask.contains(std::nan(""), 0.0));
  EXPECT_FALSE(mask.contains(0.0, HUGE_VAL));
}

TEST(PlanMask, WithoutSegmentsIsEmpty) { EXPECT_FALSE(PlanMask({}, 1.0).contains(0.0, 0.0)); }

TEST(PlanMask, RefusesUnusableInput) {
  const std::vector<Segment2> bad{{{0, 0}, {std::nan(""), 0}}};
  EXPECT_THROW(PlanMask(bad, 1.0), std::invalid_argument);
  for (const double far : {1.1e8, -1e308, HUGE_VAL}) {
    const std::vector<Segment2> huge{{{0, 0}, {1, 0}}, {{0, 0}, {0, far}}};
    EXPECT_THROW(PlanMask(huge, 1.0), std::invalid_argument) << far;
  }
  EXPECT_THROW(PlanMask({}, 0.0), std::invalid_argument);
  EXPECT_THROW(PlanMask({}, HUGE_VAL), std::invalid_argument);
}

TEST(PlanMask, FarSpreadLinesGetCoarserCells) {
  const std::vector<Segment2> segments{{{0, 0}, {1, 1}}, {{1e6, 1e6}, {1e6 + 1, 1e6}}};
  const PlanMask mask(segments, 1.0);
  EXPECT_GT(mask.cell_size_m(), 1.0);
  EXPECT_TRUE(mask.contains(1e6, 1e6 + 0.9));
  EXPECT_FALSE(mask.contains(5e5, 5e5));
}

TEST(PlanMask, NeverMissesAPointWithinTheRadius) {
  test::Random random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    const double radius = random.uniform(0.2, 3.0);
    const auto point = [&] {
      const double x = random.uniform(-20.0, 20.0);
      return Eigen::Vector2d(x, random.uniform(-20.0, 20.0));
    };
    const std::vector<Segment2> segments{{point(), point()}, {point(), point()}};
    const PlanMask mask(segments, radius);
    const Eigen::Vector2d x = point();
    const double nearest = std::min(distance(segments[0], x), distance(segments[1], x));
    if (nearest <= radius) {
      EXPECT_TRUE(mask.contains(x.x(), x.y())) << trial;
    }
    // Cells reach one cell beyond the widened band, and the band cuts a slope's end late.
    if (nearest > 4.0 * radius) {
      EXPECT_FALSE(mask.contains(x.x(), x.y())) << trial;
    }
  }
}

}  // namespace
}  // namespace ridgeline::io
