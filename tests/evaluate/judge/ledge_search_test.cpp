// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/ledge_search.h"

#include "evaluate/judge/judge_line.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::evaluate {
namespace {

// a ledge of 25 returns: sigma / sqrt(n) = 0.7 cm
constexpr double kNoisyLedge = 0.03;

/// A flat roof at 4 m for y < 0 and ground for y > 0.3, with a parapet 0.5 m high between them.
std::vector<Eigen::Vector3d> parapet_roof(std::uint64_t seed, double parapet_slope) {
  test::Random random(seed);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 1200; ++i) {
    const double x = random.uniform(-4, 16);
    const double y = random.uniform(-6, 6);
    const double surface = y < 0.0 ? 4.0 : (y < 0.3 ? 4.5 + parapet_slope * x : 0.0);
    points.emplace_back(x, y, surface + random.normal(0.03));
  }
  return points;
}

LineEvaluation judge(const std::vector<Eigen::Vector3d>& points, const Segment3& segment) {
  const PointGrid grid = PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
  JudgedLine line;
  line.id = "parapet";
  line.segment = segment;
  return judge_line(grid, line, {}).evaluation;
}

TEST(SearchLedge, JudgesAParapetByItsTopAndNotByTheRoof) {
  for (const double y : {0.0, 0.3}) {
    const LineEvaluation e = judge(parapet_roof(1, 0.0), {{0, y, 4.6}, {12, y, 4.6}});
    ASSERT_EQ(e.status, Status::kEvaluated) << e.reason;
    EXPECT_EQ(e.kind, Kind::kStep);
    EXPECT_NEAR(*e.signed_mean_m, 0.1, kNoisyLedge) << "y = " << y;
  }
}

TEST(SearchLedge, FollowsALedgeThatDescendsAlongTheLine) {
  const LineEvaluation e = judge(parapet_roof(2, 0.05), {{0, 0.15, 4.5}, {12, 0.15, 5.1}});
  ASSERT_EQ(e.status, Status::kEvaluated) << e.reason;
  EXPECT_NEAR(*e.mean_distance_m, 0.0, kNoisyLedge);
}

TEST(SearchLedge, TakesNoWideSurfaceForALedge) {
  // a car beside a marking: 1.8 m wide, 1.4 m high, its side 0.4 m from the line
  test::Random random(3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 1200; ++i) {
    const double x = random.uniform(-4, 9);
    const double y = random.uniform(-6, 6);
    const bool car = x > 0.5 && x < 4.7 && y > 0.4 && y < 2.2;
    points.emplace_back(x, y, (car ? 1.4 : 0.0) + random.normal(0.03));
  }
  const LineEvaluation e = judge(points, {{0, 0, 0.2}, {5, 0, 0.2}});
  ASSERT_EQ(e.status, Status::kEvaluated) << e.reason;
  EXPECT_NEAR(*e.signed_mean_m, 0.2, kNoisyLedge);
}

}  // namespace
}  // namespace ridgeline::evaluate
