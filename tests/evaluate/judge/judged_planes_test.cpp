// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/judged_planes.h"

#include "evaluate/judge/judge_lines.h"
#include "tests/support/sampled_roof.h"

#include <gmock/gmock.h>

namespace ridgeline::evaluate {
namespace {

using testing::SizeIs;

/// The judge's zone reaches 4 m from the line.
constexpr double kReach_m = 4.0;

std::vector<JudgedResult> judge(const std::vector<Segment3>& segments, bool keep_points = false) {
  const std::vector<Eigen::Vector3d> points = test::SampledRoof().sample(20.0, 0.0, 1);
  const auto grid = PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
  std::vector<JudgedLine> lines;
  for (const Segment3& segment : segments) {
    lines.emplace_back();
    lines.back().id = std::to_string(lines.size());
    lines.back().segment = segment;
  }
  JudgeOptions options;
  options.keep_points = keep_points;
  return judge_lines(grid, lines, options);
}

TEST(JudgedPlanes, HasEachPlaneOnceWithTheHullOfItsPoints) {
  const test::SampledRoof roof;
  const double z = roof.ridge_height_m();
  const Segment3 ridge{{0, 0, z}, {roof.length_m, 0, z}};
  const Segment3 eave{{0, 5, roof.eave_height_m}, {roof.length_m, 5, roof.eave_height_m}};
  const std::vector<JudgedResult> results = judge({ridge, eave});
  ASSERT_EQ(results[0].evaluation.kind, Kind::kRidge);
  ASSERT_EQ(results[1].evaluation.kind, Kind::kStep);
  const std::vector<JudgedPlane> planes = judged_planes(results);
  ASSERT_THAT(planes, SizeIs(2));
  int n_lines = 0;
  for (const JudgedPlane& plane : planes) {
    n_lines += plane.n_lines;
    ASSERT_GE(plane.outline.size(), 4U);
    // the plane of both lines reaches from the ridge to the eave, the other as far as the zone
    const double far_m = plane.n_lines == 2 ? roof.half_width_m : kReach_m;
    double farthest_m = 0.0;
    for (const Eigen::Vector3d& corner : plane.outline) {
      EXPECT_NEAR(corner.z(), roof.height(corner.x(), corner.y()), 1e-9);
      farthest_m = std::max(farthest_m, std::abs(corner.y()));
    }
    EXPECT_NEAR(farthest_m, far_m, 0.3);  // the points are about 0.2 m apart
  }
  EXPECT_EQ(n_lines, 3);
}

TEST(PlanePoints, AreEachOnceOfTheNearestPlane) {
  const test::SampledRoof roof;
  const double z = roof.ridge_height_m();
  const Segment3 ridge{{0, 0, z}, {roof.length_m, 0, z}};

  EXPECT_THAT(plane_points(judge({ridge, ridge})), SizeIs(0));
  const std::vector<JudgedResult> results = judge({ridge, ridge}, true);
  const std::vector<PlanePoint> points = plane_points(results);
  const std::size_t n_of_first = results[0].inliers[0].size() + results[0].inliers[1].size();
  EXPECT_EQ(points.size(), n_of_first);
  for (const PlanePoint& point : points) {
    EXPECT_NEAR(point.distance_m, 0.0, 1e-9);
    EXPECT_NEAR(point.x.z(), roof.height(point.x.x(), point.x.y()), 1e-9);
  }
  EXPECT_TRUE(std::ranges::is_sorted(points, {}, &PlanePoint::plane_id));
}

TEST(JudgedPlanes, LinesThatAreNotJudgedHaveNone) {
  EXPECT_THAT(judged_planes(judge({{{0, 0, 5}, {0, 0, 9}}})), SizeIs(0));
}

}  // namespace
}  // namespace ridgeline::evaluate
