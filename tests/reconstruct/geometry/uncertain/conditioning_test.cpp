// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/conditioning.h"

#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace ridgeline {
namespace {

constexpr double kTol = 1e-12;  // relative

const ObjectConditioning kObject{.centre_m = {100, -50, 270}, .scale_m = 40};
const ImageConditioning kImage{.centre_px = {512, 300}, .scale_px = 600};

TEST(ObjectConditioning, UndoesItself) {
  const Eigen::Vector3d x(140, -50, 230);
  EXPECT_TRUE(kObject.conditioned_from_local(x).isApprox(Eigen::Vector3d(1, 0, -1), kTol));
  EXPECT_TRUE(kObject.local_from_conditioned(kObject.conditioned_from_local(x)).isApprox(x, kTol));
}

TEST(ConditionedFromLocal, MovesALineWithItsPoints) {
  test::Random random(71);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d x = kObject.centre_m + random.vector(-40, 40);
    const Eigen::Vector3d y = kObject.centre_m + random.vector(-40, 40);
    const Vector6d in_local = pi_matrix(x.homogeneous()) * y.homogeneous();
    const Vector6d expected = pi_matrix(kObject.conditioned_from_local(x).homogeneous()) *
                              kObject.conditioned_from_local(y).homogeneous();
    const Vector6d line = conditioned_from_local(kObject, in_local) / kObject.scale_m;
    EXPECT_LT((line - expected).norm(), 1e-9);
  }
}

TEST(ConditionedFromLocal, KeepsPointsOnTheirPlane) {
  const Eigen::Vector3d x(130, -40, 260);
  const Eigen::Vector3d normal(0.6, 0.0, 0.8);
  Eigen::Vector4d plane;
  plane << normal, -normal.dot(x);
  const Eigen::Vector4d conditioned = conditioned_from_local(kObject, plane);
  EXPECT_NEAR(conditioned.dot(kObject.conditioned_from_local(x).homogeneous()), 0.0, 1e-10);
  EXPECT_TRUE(conditioned.head<3>().normalized().isApprox(normal, kTol));
}

TEST(ConditionedCamera, SeesConditionedPointsAtConditionedPixels) {
  ProjectionMatrix camera;
  camera << 1000, 0, 500, 2e5, 0, -1000, 300, 1e5, 0.01, 0, 1, 800;
  const ProjectionMatrix conditioned = conditioned_camera(camera, kImage, kObject);
  EXPECT_NEAR(conditioned.norm(), 1.0, kTol);
  test::Random random(72);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d x = kObject.centre_m + random.vector(-40, 40);
    const Eigen::Vector2d expected = kImage.conditioned_from_image(project(camera, x));
    EXPECT_LT((project(conditioned, kObject.conditioned_from_local(x)) - expected).norm(), 1e-10);
  }
}

}  // namespace
}  // namespace ridgeline
