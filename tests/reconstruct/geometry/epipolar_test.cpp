// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/epipolar.h"

#include "tests/reconstruct/support/stereo_scene.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace ridgeline {
namespace {

using test::kDegree;
using test::StereoScene;

/// A camera with f = 100 px at `centre` that looks along z.
ProjectionMatrix simple_camera(const Eigen::Vector3d& centre = Eigen::Vector3d::Zero()) {
  ProjectionMatrix p;
  p << Eigen::Matrix3d::Identity(), -centre;
  p.topRows<2>() *= 100.0;
  return p;
}

TEST(Project, HandCheckedCase) {
  EXPECT_TRUE(
      project(simple_camera(), Eigen::Vector3d(1, 2, 10)).isApprox(Eigen::Vector2d(10, 20)));
  const Segment2 s = project(simple_camera(), Segment3{{1, 2, 10}, {0, -1, 20}});
  EXPECT_TRUE(s.start.isApprox(Eigen::Vector2d(10, 20)));
  EXPECT_TRUE(s.end.isApprox(Eigen::Vector2d(0, -5)));
}

TEST(Project, IsNanInThePlaneOfTheProjectionCentre) {
  EXPECT_TRUE(project(simple_camera(), Eigen::Vector3d(1, 2, 0)).array().isNaN().all());
}

TEST(ProjectionCentre, IsProjectedToZero) {
  constexpr double kTolM = 1e-6;
  const Eigen::Vector4d centre = projection_centre(simple_camera({3, 4, 5}));
  EXPECT_TRUE(centre.hnormalized().isApprox(Eigen::Vector3d(3, 4, 5)));
  EXPECT_NEAR(centre.norm(), 1.0, 1e-12);
  const Eigen::Vector3d left = projection_centre(StereoScene().cameras[0]).hnormalized();
  EXPECT_NEAR((left - Eigen::Vector3d(-104, -10, 797)).norm(), 0.0, kTolM);
}

TEST(PointOnPlane, IsSeenAtThePixelAndLiesOnThePlane) {
  const ProjectionMatrix camera = simple_camera({1, 2, 3});
  const Plane3 plane(Eigen::Vector3d(0.1, -0.2, 1).normalized(), -12.0);
  for (const double sign : {1.0, -1.0}) {  // a matrix may have either sign
    const Eigen::Vector3d x = point_on_plane(sign * camera, {30, -40}, plane);
    EXPECT_NEAR(plane.signedDistance(x), 0.0, 1e-12);
    EXPECT_TRUE(project(camera, x).isApprox(Eigen::Vector2d(30, -40)));
  }
  // the point lies straight ahead at depth 10
  EXPECT_TRUE(point_on_plane(camera, {0, 0}, Plane3(Eigen::Vector3d::UnitZ(), -13.0))
                  .isApprox(Eigen::Vector3d(1, 2, 13)));
}

TEST(ImageFromLocal, SeesReducedCoordinatesAtTheSamePixel) {
  constexpr double kTolPx = 1e-6;  // a coordinate of 5e6 m rounds by 1e-9 m = 1e-8 px
  const Eigen::Vector3d origin(512000, 5403000, 250);
  const StereoScene scene;
  ProjectionMatrix world = scene.cameras[0];
  world.col(3) -= scene.cameras[0].leftCols<3>() * origin;
  const ProjectionMatrix local = image_from_local(world, origin);
  test::Random random(31);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d x = random.vector(-50, 50);
    EXPECT_NEAR((project(local, x) - project(scene.cameras[0], x)).norm(), 0.0, kTolPx);
  }
}

TEST(FundamentalMatrix, RelatesTheImagesOfEveryPoint) {
  constexpr double kTolPx = 1e-7;  // pixel coordinates of 1e4, F from matrices of condition 1e4
  const StereoScene scene;
  const Eigen::Matrix3d f = fundamental_matrix(scene.cameras[0], scene.cameras[1]);
  EXPECT_NEAR(f.norm(), 1.0, 1e-12);
  test::Random random(32);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector3d x = random.vector(-50, 50);
    const Eigen::Vector3d epipolar_line = f * project(scene.cameras[0], x).homogeneous();
    const double off = epipolar_line.dot(project(scene.cameras[1], x).homogeneous());
    EXPECT_NEAR(off / epipolar_line.head<2>().norm(), 0.0, kTolPx);
  }
}

TEST(FundamentalMatrix, KeepsThePixelsApartAcrossTheEpipolarLine) {
  // Base along x, equal heights: epipolar lines are rows.
  const Eigen::Matrix3d f = fundamental_matrix(simple_camera(), simple_camera({1, 0, 0}));
  const Eigen::Vector3d line = f * Eigen::Vector3d(7, 3, 1);
  EXPECT_NEAR(line.x(), 0.0, 1e-15);
  EXPECT_NEAR(std::abs(line.dot(Eigen::Vector3d(40, 5, 1)) / line.y()), 2.0, 1e-12);
}

TEST(EpipolarAngle, HandCheckedCaseWithTheEpipoleAtInfinity) {
  const std::array cameras{simple_camera(), simple_camera({1, 0, 0})};
  EXPECT_NEAR(epipolar_angle_rad(cameras[0], cameras[1], Segment2{{0, 0}, {1, 1}}), 45 * kDegree,
              1e-12);
  EXPECT_NEAR(epipolar_angle_rad(cameras, Segment3{{0, 0, 10}, {1, 0, 10}}), 0.0, 1e-12);
  EXPECT_NEAR(epipolar_angle_rad(cameras, Segment3{{0, 0, 10}, {0, 1, 10}}), 90 * kDegree, 1e-12);
}

TEST(EpipolarAngle, HandCheckedCaseWithTheEpipoleInTheImage) {
  // The other camera lies straight ahead: epipolar lines radiate from (0, 0).
  const ProjectionMatrix own = simple_camera();
  const ProjectionMatrix ahead = simple_camera({0, 0, 1});
  EXPECT_NEAR(epipolar_angle_rad(own, ahead, Segment2{{10, 10}, {20, 20}}), 0.0, 1e-12);
  EXPECT_NEAR(epipolar_angle_rad(own, ahead, Segment2{{10, -5}, {10, 5}}), 90 * kDegree, 1e-12);
}

TEST(EpipolarAngle, IsTheOneTheSegmentWasMadeWith) {
  const StereoScene scene;
  test::Random random(33);
  for (int trial = 0; trial < 200; ++trial) {
    const double theta = random.uniform(0.0, 90.0) * kDegree;
    const Segment3 s = test::make_segment(
        scene, {scene.left_centre(), theta, 100.0, random.uniform(-5, 5), random.uniform(-5, 5)});
    EXPECT_NEAR(epipolar_angle_rad(scene.cameras[0], scene.cameras[1], scene.images(s)[0]), theta,
                1e-8);
  }
}

TEST(EpipolarAngle, TakesTheSmallerOneOfTwoImagesAndTheLargestOverPairs) {
  const StereoScene scene;
  const Segment3 s =
      test::make_segment(scene, {scene.left_centre(), 20 * kDegree, 100.0, 0.0, 4.0});
  const double left = epipolar_angle_rad(scene.cameras[0], scene.cameras[1], scene.images(s)[0]);
  const double right = epipolar_angle_rad(scene.cameras[1], scene.cameras[0], scene.images(s)[1]);
  ASSERT_GT(std::abs(left - right), 1 * kDegree);
  EXPECT_DOUBLE_EQ(epipolar_angle_rad(scene.cameras, s), std::min(left, right));

  const std::array third{simple_camera(), simple_camera({1, 0, 0}), simple_camera({0, 1, 0})};
  EXPECT_NEAR(epipolar_angle_rad(third, Segment3{{0, 0, 10}, {1, 0, 10}}), 90 * kDegree, 1e-12);
}

TEST(EpipolarAngle, RejectsASingleCamera) {
  const std::array one{simple_camera()};
  EXPECT_THROW(epipolar_angle_rad(one, Segment3{{0, 0, 1}, {1, 0, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline
