// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/conditioning.h"

#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace ridgeline {
namespace {

constexpr double kConditioningTol = 1e-12;  // relative

const ObjectConditioning kObject{.centre_m = {100, -50, 270}, .scale_m = 40};
const ImageConditioning kImage{.centre_px = {512, 300}, .scale_px = 600};

TEST(ObjectConditioning, UndoesItself) {
  const Eigen::Vector3d x(140, -50, 230);
  EXPECT_TRUE(
      kObject.conditioned_from_local(x).isApprox(Eigen::Vector3d(1, 0, -1), kConditioningTol));
  EXPECT_TRUE(kObject.local_from_conditioned(kObject.conditioned_from_local(x))
                  .isApprox(x, kConditioningTol));
}

TEST(ConditionedCamera, SeesConditionedPointsAtConditionedPixels) {
  ProjectionMatrix camera;
  camera << 1000, 0, 500, 2e5, 0, -1000, 300, 1e5, 0.01, 0, 1, 800;
  const ProjectionMatrix conditioned = conditioned_camera(camera, kImage, kObject);
  EXPECT_NEAR(conditioned.norm(), 1.0, kConditioningTol);
  test::Random random(72);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d x = kObject.centre_m + random.vector(-40, 40);
    const Eigen::Vector2d expected = kImage.conditioned_from_image(project(camera, x));
    EXPECT_LT((project(conditioned, kObject.conditioned_from_local(x)) - expected).norm(), 1e-10);
  }
}

}  // namespace
}  // namespace ridgeline
