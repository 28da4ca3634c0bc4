// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/conditioned_view.h"

#include "tests/reconstruct/support/conditioned_scene.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

TEST(Condition, BringsThePatchToUnitSizeInBothFrames) {
  const test::ConditionedScene scene;
  EXPECT_LT((scene.frames.object.centre_m - Eigen::Vector3d(0, 0, 2.5)).norm(), 1.0);
  for (const Eigen::Vector3d& corner :
       {Eigen::Vector3d(-20, -20, 0), Eigen::Vector3d(20, 20, 5), Eigen::Vector3d(20, -20, 5)}) {
    EXPECT_LT(scene.conditioned(corner).norm(), 1.2);
    EXPECT_GT(scene.conditioned(corner).norm(), 0.8);
    for (std::size_t j = 0; j < 2; ++j) {
      const Eigen::Vector2d x = scene.frames.views[j].image.conditioned_from_image(
          project(scene.scene.cameras[j], corner));
      EXPECT_LT(x.norm(), 1.01);
      EXPECT_GT(x.norm(), 0.9);
      EXPECT_LT(
          (project(scene.frames.views[j].image_from_object, scene.conditioned(corner)) - x).norm(),
          1e-9);
    }
  }
}

TEST(Condition, RejectsAnEmptyPatchAndParallelRays) {
  const test::StereoScene scene;
  const std::vector<Segment2> patch{{{0, 0}, {10, 10}}};
  const std::vector<Segment2> empty;
  EXPECT_THROW(condition(scene.cameras, std::array{patch, empty}), std::invalid_argument);
  const std::vector<Segment2> point{{{5, 5}, {5, 5}}};
  EXPECT_THROW(condition(scene.cameras, std::array{patch, point}), std::invalid_argument);
  const std::array same{scene.cameras[0], scene.cameras[0]};
  EXPECT_THROW(condition(same, std::array{patch, patch}), std::invalid_argument);
  EXPECT_THROW(condition(scene.cameras, std::array{patch}), std::invalid_argument);
}

TEST(Condition, LetsAThirdImageWithoutSegmentsKeepItsPixels) {
  const test::StereoScene scene;
  const std::vector<Segment2> patch{{{0, 0}, {10, 10}}};
  const std::array cameras{scene.cameras[0], scene.cameras[1], scene.cameras[0]};
  const ConditionedViews frames =
      condition(cameras, std::array{patch, patch, std::vector<Segment2>{}});
  EXPECT_EQ(frames.views[2].image.scale_px, 1.0);
  EXPECT_LT((frames.fundamental(0, 1) - frames.fundamental(1, 0).transpose()).norm(), 1e-15);
}

TEST(InFront, IgnoresTheSignOfPointAndCamera) {
  const test::ConditionedScene scene;
  const Eigen::Vector4d below = scene.conditioned({3, 4, 5}).homogeneous();
  const Eigen::Vector4d above_the_camera = scene.conditioned({3, 4, 1600}).homogeneous();
  for (ConditionedView view : scene.frames.views) {
    for (const double sign : {1.0, -1.0}) {
      view.image_from_object *= sign;
      EXPECT_TRUE(in_front(view, below));
      EXPECT_TRUE(in_front(view, -2.0 * below));
      EXPECT_FALSE(in_front(view, above_the_camera));
      EXPECT_FALSE(in_front(view, Eigen::Vector4d(1, 2, 3, 0)));  // at infinity
    }
  }
}

TEST(Observe, HoldsTheConditionedSegmentItsLineAndPlane) {
  const test::ConditionedScene scene;
  const Segment3 truth{{-3, 1, 2}, {4, 6, 7}};
  const auto observed = scene.observe(test::exact_pair(scene.scene, truth));
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_NEAR(observed.observations[j].line.mean.dot(
                    observed.observations[j].segment.start.homogeneous()),
                0.0, 1e-12);
    EXPECT_NEAR(observed.observations[j].plane.mean.norm(), 1.0, 1e-12);
    EXPECT_NEAR(observed.observations[j].plane.mean.dot(scene.conditioned(truth.end).homogeneous()),
                0.0, 1e-12);
    EXPECT_NEAR(observed.observations[j].sigma_e * scene.frames.views[j].image.scale_px, 1.0,
                1e-12);
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
