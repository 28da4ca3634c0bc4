// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_support.h"

#include "evaluate/judge/candidate_planes.h"
#include "evaluate/judge/point_grid.h"
#include "tests/support/random.h"
#include "tests/support/sampled_roof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kSupportTol = 1e-12;

std::vector<ZonePoint> zone_at(const std::vector<Eigen::Vector2d>& st) {
  std::vector<ZonePoint> points;
  for (const Eigen::Vector2d& p : st) {
    points.push_back(
        {{p.x(), p.y(), 0.0}, p.x(), p.y(), static_cast<std::uint32_t>(points.size())});
  }
  return points;
}

Footprint along_x(double length_m) { return footprint_of({{0, 0, 0}, {length_m, 0, 0}}); }

TEST(CoverageAlong, CountsOverlapsOnceAndStopsAtTheEnds) {
  EXPECT_NEAR(coverage_along(zone_at({{2, 0}, {2.5, 1}}), 10.0, 0.5), 0.15, kSupportTol);
  EXPECT_NEAR(coverage_along(zone_at({{-0.3, 0}}), 10.0, 0.5), 0.02, kSupportTol);
  EXPECT_NEAR(coverage_along(zone_at({{12, 0}}), 10.0, 0.5), 0.0, kSupportTol);
  EXPECT_NEAR(coverage_along(zone_at({{5, 0}}), 10.0, 50.0), 1.0, kSupportTol);
  EXPECT_NEAR(coverage_along({}, 10.0, 1.0), 0.0, kSupportTol);
}

TEST(ExtrapolationBeyond, IsZeroInsideTheHullAndTheDistanceOutside) {
  const auto square = zone_at({{0, -1}, {10, -1}, {10, 1}, {0, 1}, {5, 0}});
  EXPECT_NEAR(extrapolation_beyond(square, along_x(10)), 0.0, kSupportTol);
  EXPECT_NEAR(extrapolation_beyond(square, along_x(13)), 3.0, kSupportTol);
  const auto aside = zone_at({{0, 2}, {10, 2}, {10, 4}, {0, 4}});
  EXPECT_NEAR(extrapolation_beyond(aside, along_x(10)), 2.0, kSupportTol);
}

TEST(ExtrapolationBeyond, TakesDegenerateHulls) {
  EXPECT_NEAR(extrapolation_beyond(zone_at({{0, 3}}), along_x(4)), 5.0, kSupportTol);
  EXPECT_NEAR(extrapolation_beyond(zone_at({{0, 3}, {4, 3}}), along_x(4)), 3.0, kSupportTol);
  EXPECT_EQ(extrapolation_beyond({}, along_x(4)), HUGE_VAL);
}

std::vector<ZonePoint> zone_of(const std::vector<Eigen::Vector3d>& points,
                               const Footprint& footprint,
                               const JudgeOptions& options) {
  const PointGrid grid = PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
  return points_beside(grid, footprint, options.fit_half_width_m, options.fit_half_width_m);
}

TEST(CandidatePlanes, GivesBothSlopesOfARoofAtItsRidge) {
  const test::SampledRoof roof;
  const JudgeOptions options;
  const Footprint ridge = footprint_of({{0, 0, 0}, {roof.length_m, 0, 0}});
  auto planes =
      candidate_planes(zone_of(roof.sample(5.0, 0.034, 1), ridge, options), ridge, options);
  std::erase_if(planes, [](const CandidatePlane& p) { return p.coverage < 0.9; });  // ground ahead
  ASSERT_EQ(planes.size(), 2U);
  for (const CandidatePlane& plane : planes) {
    EXPECT_NEAR(slope_rad(plane.fit.plane), std::atan(roof.slope), 0.01);
  }
}

TEST(CandidatePlanes, UnitesAPlaneFoundOnBothSides) {
  const test::SampledRoof roof;
  const JudgeOptions options;
  const Footprint inside = footprint_of({{2, 2.5, 0}, {10, 2.5, 0}});
  EXPECT_EQ(candidate_planes(zone_of(roof.sample(5.0, 0.034, 2), inside, options), inside, options)
                .size(),
            1U);
}

TEST(CandidatePlanes, ExtendsThePlaneBeyondTheCorridor) {
  const test::SampledRoof roof;
  const JudgeOptions options;
  const Footprint eave = footprint_of({{0, 5, 0}, {roof.length_m, 5, 0}});
  const auto planes =
      candidate_planes(zone_of(roof.sample(5.0, 0.034, 3), eave, options), eave, options);
  const auto upper = std::max_element(
      planes.begin(), planes.end(),
      [](const auto& a, const auto& b) { return a.fit.centroid.z() < b.fit.centroid.z(); });
  ASSERT_NE(upper, planes.end());
  // 12 m x 4 m of roof at 5 points/m2 instead of the corridor's 12 m x 1.5 m
  EXPECT_GT(upper->inliers.size(), 180U);
  EXPECT_LT(upper->beside.size(), 110U);
}

TEST(CandidatePlanes, LeavesOutACanopy) {
  test::Random random(4);
  std::vector<Eigen::Vector3d> tree;
  for (int i = 0; i < 1500; ++i) {
    const double x = random.uniform(-4, 12);
    const double y = random.uniform(-4, 4);
    tree.emplace_back(x, y, random.uniform(0.0, 1.0) < 0.2 ? 0.0 : random.uniform(3, 6));
  }
  const JudgeOptions options;
  const Footprint line = along_x(8);
  for (const CandidatePlane& plane :
       candidate_planes(zone_of(tree, line, options), line, options)) {
    EXPECT_NEAR(plane.fit.centroid.z(), 0.0, 0.05);  // the ground below remains
  }
}

/// Level ground from `n` points with noise of 3.4 cm, spread evenly over a strip along a line of 10
/// m that reaches from the line to 1.5 m on its left.
CandidatePlane strip_of_ground(int n) {
  constexpr double kLength_m = 10.0, kWidth_m = 1.5;
  CandidatePlane plane;
  plane.fit.plane = Plane3(Eigen::Vector3d::UnitZ(), 0.0);
  plane.fit.centroid = {0.5 * kLength_m, 0.5 * kWidth_m, 0.0};
  plane.fit.axes << 1.0, 0.0, 0.0, 1.0, 0.0, 0.0;
  // a uniform distribution of width w has the variance w^2 / 12
  plane.fit.spread_m2 = n * Eigen::Vector2d(kLength_m, kWidth_m).cwiseAbs2() / 12.0;
  plane.fit.n = n;
  plane.fit.sigma0_m = 0.034;
  return plane;
}

TEST(ReasonTooLittleKnown, IsAPlaneKnownLessWellThanThreePointsWouldTell) {
  constexpr std::array<std::size_t, 1> kChosen{0};
  const auto reason = [&](int n) {
    return reason_too_little_known(std::array{strip_of_ground(n)}, kChosen, along_x(10), {});
  };
  // at the border of a strip n points tell as much as n / 4 at the place: 1/n + (w/2)^2 / (n
  // w^2/12) = 4/n
  EXPECT_FALSE(reason(13));
  EXPECT_EQ(reason(11), "the sigma of its plane at the line is 0.0205 m, must be at most 0.0196 m");
}

}  // namespace
}  // namespace ridgeline::evaluate
