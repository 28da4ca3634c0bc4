// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/segment_plane.h"

#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ridgeline {
namespace {

constexpr double kDistanceTol = 1e-12;  // a few roundings of coordinates up to 30

TEST(OrthogonalDistance, HandCheckedCases) {
  struct Case {
    const char* name;
    Segment3 segment;
    double mean_abs, mean, rms, max_abs;
  };
  const Plane3 ground(Eigen::Vector3d::UnitZ(), 0.0);
  for (const Case& c : {
           Case{"parallel", {{0, 0, 2}, {5, 1, 2}}, 2.0, 2.0, 2.0, 2.0},
           Case{"crossing in the middle", {{0, 0, -3}, {1, 0, 3}}, 1.5, 0.0, std::sqrt(3.0), 3.0},
           Case{"crossing at a quarter", {{0, 0, -1}, {1, 0, 3}}, 1.25, 1.0, std::sqrt(7.0 / 3), 3},
           Case{"below, unequal ends", {{0, 0, -4}, {1, 0, -1}}, 2.5, -2.5, std::sqrt(7.0), 4.0},
           Case{"one end on the plane", {{0, 0, 0}, {1, 0, 3}}, 1.5, 1.5, std::sqrt(3.0), 3.0},
           Case{"within the plane", {{0, 0, 0}, {1, 5, 0}}, 0.0, 0.0, 0.0, 0.0},
           Case{"zero length", {{1, 2, 4}, {1, 2, 4}}, 4.0, 4.0, 4.0, 4.0},
       }) {
    const SegmentPlaneDistance d = orthogonal_distance(c.segment, ground);
    EXPECT_NEAR(d.start, c.segment.start.z(), kDistanceTol) << c.name;
    EXPECT_NEAR(d.end, c.segment.end.z(), kDistanceTol) << c.name;
    EXPECT_NEAR(d.mean_abs, c.mean_abs, kDistanceTol) << c.name;
    EXPECT_NEAR(d.mean, c.mean, kDistanceTol) << c.name;
    EXPECT_NEAR(d.rms, c.rms, kDistanceTol) << c.name;
    EXPECT_NEAR(d.max_abs, c.max_abs, kDistanceTol) << c.name;
  }
}

TEST(OrthogonalDistance, RejectsNormalThatIsNotUnit) {
  for (const double length : {0.0, 1.0 + 1e-8, std::numeric_limits<double>::quiet_NaN()}) {
    const Plane3 plane(Eigen::Vector3d(0, 0, length), 0.0);
    EXPECT_THROW(orthogonal_distance({{0, 0, 0}, {1, 0, 0}}, plane), std::invalid_argument);
  }
}

TEST(OrthogonalDistance, ClosedFormsAgreeWithSampling) {
  constexpr int kSamples = 2000;
  constexpr double kSamplingTol = 1e-4;  // the midpoint rule at a kink: slope * step^2 / length
  test::Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Segment3 s{random.vector(-10, 10), random.vector(-10, 10)};
    const Plane3 plane(random.vector(-1, 1).normalized(), random.vector(-5, 5));
    double sum_abs = 0.0;
    double sum_squares = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const double d = plane.signedDistance(point_at(s, (i + 0.5) / kSamples));
      sum_abs += std::abs(d);
      sum_squares += d * d;
    }
    const SegmentPlaneDistance d = orthogonal_distance(s, plane);
    EXPECT_NEAR(d.mean_abs, sum_abs / kSamples, kSamplingTol) << trial;
    EXPECT_NEAR(d.rms, std::sqrt(sum_squares / kSamples), kSamplingTol) << trial;
  }
}

TEST(OrthogonalDistance, IgnoresDirectionSideAndRigidMotion) {
  test::Random random(8);
  for (int trial = 0; trial < 1000; ++trial) {
    SCOPED_TRACE(trial);
    const Segment3 s{random.vector(-10, 10), random.vector(-10, 10)};
    const Eigen::Vector3d normal = random.vector(-1, 1).normalized();
    const Eigen::Vector3d origin = random.vector(-10, 10);
    const SegmentPlaneDistance expected = orthogonal_distance(s, Plane3(normal, origin));

    const Eigen::Isometry3d b_from_a =
        Eigen::Translation3d(random.vector(-10, 10)) *
        Eigen::AngleAxisd(random.uniform(-3, 3), random.vector(-1, 1).normalized());
    const Segment3 s_in_b{b_from_a * s.start, b_from_a * s.end};
    const Plane3 plane_in_b(b_from_a.linear() * normal, b_from_a * origin);
    for (const SegmentPlaneDistance& actual :
         {orthogonal_distance({s.end, s.start}, Plane3(-normal, origin)),
          orthogonal_distance(s_in_b, plane_in_b)}) {
      EXPECT_NEAR(actual.mean_abs, expected.mean_abs, kDistanceTol);
      EXPECT_NEAR(std::abs(actual.mean), std::abs(expected.mean), kDistanceTol);
      EXPECT_NEAR(actual.rms, expected.rms, kDistanceTol);
      EXPECT_NEAR(actual.max_abs, expected.max_abs, kDistanceTol);
    }
  }
}

}  // namespace
}  // namespace ridgeline
