// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/segment.h"

#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace ridgeline {
namespace {

constexpr double kSegmentTol = 1e-12;  // a few roundings of coordinates up to 10

Segment2 random_segment(test::Random& random) {
  return {random.vector(-10, 10).head<2>(), random.vector(-10, 10).head<2>()};
}

TEST(Distance, IsClampedAtTheEndsOfASegment) {
  const Segment2 s{{0, 0}, {4, 0}};
  EXPECT_DOUBLE_EQ(distance(s, {2, 3}), 3.0);
  EXPECT_DOUBLE_EQ(distance(s, {7, 4}), 5.0);
  EXPECT_DOUBLE_EQ(distance(s, {14, 0}), 10.0);  // on the infinite line
  const Segment3 t{{0, 0, 0}, {0, 0, 2}};
  EXPECT_DOUBLE_EQ(distance(t, {0, 0, -1}), 1.0);
  EXPECT_DOUBLE_EQ(distance(t, {3, 4, 1}), 5.0);
}

TEST(ClosestParameter, IsZeroForASegmentOfZeroLength) {
  EXPECT_EQ(closest_parameter(Segment2{{1, 1}, {1, 1}}, {5, 5}), 0.0);
  EXPECT_DOUBLE_EQ(distance(Segment3{{1, 1, 1}, {1, 1, 1}}, {1, 1, 3}), 2.0);
}

TEST(ClosestParameter, RunsFromStartToEnd) {
  const Segment3 s{{0, 0, 0}, {4, 0, 0}};
  EXPECT_DOUBLE_EQ(closest_parameter(s, {1, 5, 5}), 0.25);
  EXPECT_DOUBLE_EQ(closest_parameter(s, {-1, 0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(closest_parameter(s, {9, 0, 0}), 1.0);
  EXPECT_TRUE(point_at(s, 0.25).isApprox(Eigen::Vector3d(1, 0, 0)));
}

TEST(SegmentDistance, HandCheckedCases) {
  struct Case {
    const char* name;
    Segment2 a, b;
    double distance;
  };
  for (const Case& c : {Case{"crossing", {{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}, 0.0},
                        Case{"T junction", {{-1, 0}, {1, 0}}, {{0, 0}, {0, 1}}, 0.0},
                        Case{"T with a gap", {{-1, 0}, {1, 0}}, {{0, 0.5}, {0, 3}}, 0.5},
                        Case{"collinear apart", {{0, 0}, {1, 0}}, {{3, 0}, {5, 0}}, 2.0},
                        Case{"collinear overlapping", {{0, 0}, {4, 0}}, {{3, 0}, {5, 0}}, 0.0},
                        Case{"parallel", {{0, 0}, {4, 0}}, {{1, 2}, {9, 2}}, 2.0},
                        Case{"corner to corner", {{0, 0}, {1, 0}}, {{4, 4}, {4, 9}}, 5.0},
                        Case{"both points", {{0, 0}, {0, 0}}, {{3, 4}, {3, 4}}, 5.0}}) {
    EXPECT_NEAR(distance(c.a, c.b), c.distance, kSegmentTol) << c.name;
    EXPECT_NEAR(distance(c.b, c.a), c.distance, kSegmentTol) << c.name;
  }
}

TEST(SegmentDistance, AgreesWithDenseSampling) {
  constexpr int kSamples = 400;
  test::Random random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const Segment2 a = random_segment(random);
    const Segment2 b = random_segment(random);
    double sampled = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSamples; ++i) {
      const double t = static_cast<double>(i) / kSamples;
      sampled = std::min(sampled, distance(b, Eigen::Vector2d((1 - t) * a.start + t * a.end)));
    }
    const double half_step = 0.5 * length(a) / kSamples;  // the sample nearest to the closest point
    EXPECT_LE(distance(a, b), sampled + kSegmentTol) << trial;
    EXPECT_GE(distance(a, b), sampled - half_step - kSegmentTol) << trial;
  }
}

TEST(AcuteAngle, HandCheckedCases) {
  EXPECT_DOUBLE_EQ(acute_angle_rad(Eigen::Vector2d(1, 0), Eigen::Vector2d(-2, 0)), 0.0);
  EXPECT_DOUBLE_EQ(acute_angle_rad(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 3)),
                   std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(acute_angle_rad(Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 1)),
                   std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(acute_angle_rad(Eigen::Vector3d(0, 1, 1), Eigen::Vector3d(0, 1, 0)),
                   std::numbers::pi / 4);
  EXPECT_EQ(acute_angle_rad(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0)), 0.0);
}

TEST(AcuteAngle, StaysExactForTinyAngles) {
  // acos of the cosine would return 0 here
  EXPECT_NEAR(acute_angle_rad(Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1e-9)), 1e-9, 1e-20);
}

TEST(AcuteAngle, IgnoresLengthAndSignOfDirections) {
  test::Random random(12);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector3d a = random.vector(-1, 1);
    const Eigen::Vector3d b = random.vector(-1, 1);
    const double angle = acute_angle_rad(a, b);
    EXPECT_NEAR(acute_angle_rad(Eigen::Vector3d(-3 * a), Eigen::Vector3d(7 * b)), angle,
                kSegmentTol);
    EXPECT_NEAR(acute_angle_rad(b, a), angle, kSegmentTol);
    EXPECT_GE(angle, 0.0);
    EXPECT_LE(angle, std::numbers::pi / 2);
  }
}

TEST(AllFinite, SeesEveryCoordinate) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(all_finite({{0, 0, 0}, {1, 1, 1}}));
  EXPECT_FALSE(all_finite({{0, nan, 0}, {1, 1, 1}}));
  EXPECT_FALSE(all_finite({{0, 0, 0}, {1, 1, std::numeric_limits<double>::infinity()}}));
}

TEST(Segment, LengthMidpointAndPlan) {
  const Segment3 s{{1, 2, 3}, {3, 5, 9}};
  EXPECT_DOUBLE_EQ(length(s), 7.0);
  EXPECT_TRUE(midpoint(s).isApprox(Eigen::Vector3d(2, 3.5, 6)));
  EXPECT_DOUBLE_EQ(length(plan(s)), std::sqrt(13.0));
  EXPECT_TRUE(midpoint(plan(s)).isApprox(Eigen::Vector2d(2, 3.5)));
}

}  // namespace
}  // namespace ridgeline
