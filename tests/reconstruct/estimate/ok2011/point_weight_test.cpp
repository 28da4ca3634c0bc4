// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/point_weight.h"

#include "tests/reconstruct/support/stereo_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::kDegree;

constexpr double kTol = 1e-12;

double weight(double distance_px, double epipolar_distance_px, double angle_deg = 45.0) {
  return point_weight({distance_px, epipolar_distance_px, angle_deg * kDegree});
}

TEST(PointWeight, IsEquation6) {
  EXPECT_NEAR(weight(0, 0), 1.0, kTol);
  EXPECT_NEAR(weight(5, 0), std::exp(-0.5), kTol);
  EXPECT_NEAR(weight(10, 4), std::exp(-2.0), kTol);
  // as printed: exp(-(sigma_2 d + sigma_1 d_e) / (2 sigma_1 sigma_2))
  EXPECT_NEAR(weight(3, 1.5), std::exp(-(2 * 3 + 5 * 1.5) / (2 * 5 * 2)), kTol);
}

TEST(PointWeight, IsZeroForANarrowIntersection) {
  EXPECT_EQ(weight(0, 0, 5.0), 0.0);
  EXPECT_EQ(weight(0, 0, 10.0 - 1e-9), 0.0);
  EXPECT_GT(weight(0, 0, 10.0 + 1e-9), 0.0);
  EXPECT_EQ(point_weight({0, 0, std::nan("")}), 0.0);
}

TEST(SmallerOfEach, TakesEachMeasureFromTheImageWhereItIsSmaller) {
  const PairMeasures smaller =
      smallest_of_each(std::array{PairMeasures{3, 1, 0.5}, PairMeasures{2, 4, 0.7}});
  EXPECT_EQ(smaller.distance_px, 2);
  EXPECT_EQ(smaller.epipolar_distance_px, 1);
  EXPECT_EQ(smaller.angle_rad, 0.5);
}

TEST(Region, SplitsAtTheThirdsAndIsUnboundedOutside) {
  EXPECT_EQ(region(-5.0), Region::kLeft);
  EXPECT_EQ(region(0.0), Region::kLeft);
  EXPECT_EQ(region(std::nextafter(1.0 / 3.0, 0.0)), Region::kLeft);
  EXPECT_EQ(region(1.0 / 3.0), Region::kCentre);
  EXPECT_EQ(region(2.0 / 3.0), Region::kCentre);
  EXPECT_EQ(region(std::nextafter(2.0 / 3.0, 1.0)), Region::kRight);
  EXPECT_EQ(region(7.0), Region::kRight);
}

TEST(SelectPoints, TakesTheBestOfEachRegion) {
  // Figure 6 of the paper: a far point on the left, two near ones on the right
  const std::vector<RankedPoint> points{{.parameter = 0.9, .weight = 0.9, .neighbour = 1},
                                        {.parameter = 1.0, .weight = 0.8, .neighbour = 2},
                                        {.parameter = -0.2, .weight = 0.1, .neighbour = 3}};
  EXPECT_EQ(select_points(points), (std::vector<std::size_t>{2, 0}));
}

TEST(SelectPoints, DiscardsWeightsUpToTheThreshold) {
  const std::vector<RankedPoint> points{{.parameter = 0.1, .weight = 0.01},
                                        {.parameter = 0.5, .weight = 0.0100001},
                                        {.parameter = 0.9, .weight = 0.0}};
  EXPECT_EQ(select_points(points), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(select_points({}).empty());
}

TEST(SelectPoints, BreaksTiesByOmegaThenByNeighbour) {
  const std::vector<RankedPoint> points{
      {.parameter = 0.5, .weight = 0.5, .omega = 2.0, .neighbour = 1},
      {.parameter = 0.5, .weight = 0.5, .omega = 1.0, .neighbour = 9},
      {.parameter = 0.5, .weight = 0.5, .omega = 1.0, .neighbour = 4}};
  EXPECT_EQ(select_points(points), (std::vector<std::size_t>{2}));
}

TEST(SelectPoints, ThresholdIsTheDistanceStatedForIt) {
  // W = 0.01 at d = 10 ln 100 = 46.1 px on the epipolar line, or 4 ln 100 = 18.4 px off it
  EXPECT_GT(weight(46.0, 0), kMinWeight);
  EXPECT_LT(weight(46.1, 0), kMinWeight);
  EXPECT_GT(weight(0, 18.4), kMinWeight);
  EXPECT_LT(weight(0, 18.5), kMinWeight);
}

}  // namespace
}  // namespace ridgeline::reconstruct
