// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/plane.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ridgeline {
namespace {

constexpr double kPlaneTol = 1e-12;

TEST(Upward, TurnsTheNormalUpwards) {
  const Plane3 roof(Eigen::Vector3d(0.6, 0, -0.8), 5.0);
  EXPECT_TRUE(upward(roof).coeffs().isApprox(Eigen::Vector4d(-0.6, 0, 0.8, -5)));
}

TEST(Upward, TurnsTheNormalOfAVerticalPlaneTowardsIncreasingXThenY) {
  EXPECT_TRUE(upward(Plane3(Eigen::Vector3d(-1, 0, 0), 2.0))
                  .coeffs()
                  .isApprox(Eigen::Vector4d(1, 0, 0, -2)));
  EXPECT_TRUE(upward(Plane3(Eigen::Vector3d(0, -1, 0), 2.0))
                  .coeffs()
                  .isApprox(Eigen::Vector4d(0, 1, 0, -2)));
}

TEST(Upward, IsTheSameForBothNormalsOfAPlane) {
  test::Random random(21);
  for (int trial = 0; trial < 1000; ++trial) {
    const Plane3 plane(random.vector(-1, 1).normalized(), random.vector(-5, 5));
    const Plane3 turned(Eigen::Vector3d(-plane.normal()), -plane.offset());
    EXPECT_TRUE(upward(plane).coeffs().isApprox(upward(turned).coeffs()));
    EXPECT_GE(upward(plane).normal().z(), 0.0);
  }
}

TEST(HeightAt, LiesOnThePlane) {
  test::Random random(22);
  for (int trial = 0; trial < 1000; ++trial) {
    Eigen::Vector3d normal = random.vector(-1, 1);
    normal.z() = random.uniform(0.5, 1.0);
    const Plane3 plane(normal.normalized(), random.vector(-5, 5));
    const Eigen::Vector2d x = random.vector(-10, 10).head<2>();
    const Eigen::Vector3d on_plane(x.x(), x.y(), height_at(plane, x));
    EXPECT_NEAR(plane.signedDistance(on_plane), 0.0, kPlaneTol);
  }
}

TEST(HeightAt, IsNotFiniteForAVerticalPlane) {
  const Plane3 wall(Eigen::Vector3d::UnitX(), 0.0);
  EXPECT_FALSE(std::isfinite(height_at(wall, {1, 0})));
  EXPECT_FALSE(std::isfinite(height_at(wall, {0, 0})));
}

TEST(Slope, HandCheckedCases) {
  EXPECT_EQ(slope_rad(Plane3(Eigen::Vector3d::UnitZ(), 1.0)), 0.0);
  EXPECT_DOUBLE_EQ(slope_rad(Plane3(Eigen::Vector3d::UnitX(), 1.0)), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(slope_rad(Plane3(Eigen::Vector3d(0, -1, -1).normalized(), 1.0)),
                   std::numbers::pi / 4);
}

}  // namespace
}  // namespace ridgeline
