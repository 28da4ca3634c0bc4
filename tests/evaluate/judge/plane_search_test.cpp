// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_search.h"

#include "evaluate/judge/plane_support.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// A roof plane z = 8 + 0.5 t over the ground z = 0 and a wall x = 0, in known shares.
std::vector<ZonePoint> roof_ground_wall(std::uint64_t seed) {
  test::Random random(seed);
  std::vector<ZonePoint> points;
  const auto add = [&](const Eigen::Vector3d& x) {
    points.push_back({x, x.x(), x.y(), static_cast<std::uint32_t>(points.size())});
  };
  for (int i = 0; i < 80; ++i) {
    const double s = random.uniform(0, 10);
    const double t = random.uniform(0.2, 1.5);
    add({s, t, 8.0 + 0.5 * t + random.normal(0.03)});
  }
  for (int i = 0; i < 40; ++i) {
    const double s = random.uniform(0, 10);
    const double t = random.uniform(0.2, 1.5);
    add({s, t, random.normal(0.03)});
  }
  for (int i = 0; i < 25; ++i) {
    const double t = random.uniform(0.2, 1.5);
    add({random.normal(0.03), t, random.uniform(0, 8)});
  }
  return points;
}

TEST(SearchPlanes, FindsTheRoofThenTheGroundAndNoWall) {
  for (const SampleConsensus method :
       {SampleConsensus::kMsac, SampleConsensus::kRansac, SampleConsensus::kProsac}) {
    JudgeOptions options;
    options.method = method;
    const std::vector<FoundPlane> planes = search_planes(roof_ground_wall(3), options);
    ASSERT_EQ(planes.size(), 2U) << static_cast<int>(method);
    EXPECT_NEAR(slope_rad(planes[0].fit.plane), std::atan(0.5), 0.03);
    EXPECT_NEAR(slope_rad(planes[1].fit.plane), 0.0, 0.05);
    EXPECT_GE(planes[0].inliers.size(), 75U);
  }
}

TEST(SearchPlanes, RefinesAPlaneUntilItsPointsStayTheSame) {
  const auto points = roof_ground_wall(5);
  for (const FoundPlane& plane : search_planes(points, {})) {
    const std::optional<PlaneFit> again = fit_plane(positions(plane.inliers));
    ASSERT_TRUE(again);
    EXPECT_EQ(plane.fit.plane.coeffs(), again->plane.coeffs());
  }
}

TEST(SearchPlanes, FindsNoneInScatter) {
  test::Random random(8);
  std::vector<ZonePoint> points;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Eigen::Vector3d x(random.uniform(0, 10), random.uniform(0.2, 1.5), random.uniform(0, 9));
    points.push_back({x, x.x(), x.y(), i});
  }
  for (const FoundPlane& plane : search_planes(points, {})) {
    EXPECT_LT(plane.inliers.size(), 20U);  // a slab of a thicket, never a surface
  }
}

TEST(SearchPlanes, NeedsTheStatedNumberOfPoints) {
  std::vector<ZonePoint> points = roof_ground_wall(3);
  points.resize(static_cast<std::size_t>(JudgeOptions{}.min_points) - 1);
  EXPECT_TRUE(search_planes(points, {}).empty());
}

}  // namespace
}  // namespace ridgeline::evaluate
