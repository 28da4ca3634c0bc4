// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/rectification.h"

#include "tests/reconstruct/support/stereo_scene.h"

#include <gtest/gtest.h>

namespace ridgeline::reconstruct {
namespace {

constexpr double kRectified_px = 1e-7;  // rounding of thousands of pixels
constexpr double kExact_m = 1e-7;       // rounding of hundreds of metres
const cv::Size kSize(7680, 13824);
const std::array kPoints{Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(60.0, -80.0, 12.0),
                         Eigen::Vector3d(-40.0, 30.0, -5.0)};

/// The scene with the right image turned in its plane.
std::array<ProjectionMatrix, 2> cameras_turned_by(double angle_deg) {
  std::array<ProjectionMatrix, 2> cameras = test::StereoScene(5.0).cameras;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle_deg * test::kDegree, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  cameras[1] = turn * cameras[1];
  return cameras;
}

TEST(Rectification, BringsWhatCorrespondsIntoOneRowForAnyTurnOfTheViews) {
  for (const double angle_deg : {0.0, 37.0, 90.0, 180.0, 270.0}) {
    const auto cameras = cameras_turned_by(angle_deg);
    const auto r = rectification(cameras, kSize);
    ASSERT_TRUE(r) << angle_deg;
    for (const Eigen::Vector3d& x : kPoints) {
      const Eigen::Vector2d left = r->rectified(0, project(cameras[0], x));
      const Eigen::Vector2d right = r->rectified(1, project(cameras[1], x));
      EXPECT_NEAR(left.y(), right.y(), kRectified_px) << angle_deg;
      EXPECT_NEAR(left.x() - right.x(), r->disparity_px(x), kRectified_px) << angle_deg;
      EXPECT_LT((r->point_in_local(left, r->disparity_px(x)) - x).norm(), kExact_m) << angle_deg;
      EXPECT_NEAR(r->disparity_at_height_px(left, x.z()), r->disparity_px(x), kRectified_px);
    }
  }
}

TEST(Rectification, DoesNotDependOnTheSignOfTheMatrices) {
  auto cameras = cameras_turned_by(0.0);
  const auto r = rectification(cameras, kSize);
  cameras[0] = -cameras[0];
  cameras[1] = -3.0 * cameras[1];
  const auto of_others = rectification(cameras, kSize);
  ASSERT_TRUE(r && of_others);
  for (const Eigen::Vector3d& x : kPoints)
    EXPECT_NEAR(r->disparity_px(x), of_others->disparity_px(x), kRectified_px);
}

TEST(Rectification, KeepsTheSizeOfThePixelsAndTheWholeLeftImage) {
  const auto r = rectification(cameras_turned_by(0.0), kSize);
  ASSERT_TRUE(r);
  const Eigen::Vector2d middle(0.5 * kSize.width, 0.5 * kSize.height);
  const Eigen::Vector2d a = r->rectified(0, middle);
  EXPECT_NEAR((r->rectified(0, middle + Eigen::Vector2d(1.0, 0.0)) - a).norm(), 1.0, 0.01);
  for (const double x : {0.0, kSize.width - 1.0}) {
    for (const double y : {0.0, kSize.height - 1.0}) {
      const Eigen::Vector2d seen = r->rectified(0, {x, y});
      EXPECT_TRUE(seen.minCoeff() > -kRectified_px &&
                  seen.x() <= r->size.width - 1 + kRectified_px &&
                  seen.y() <= r->size.height - 1 + kRectified_px);
    }
  }
}

TEST(Rectification, OfViewsThatLookAlongTheBaseIsNone) {
  std::array<ProjectionMatrix, 2> cameras = test::StereoScene(0.0).cameras;
  cameras[1] = cameras[0];
  cameras[1].col(3) = -cameras[0].leftCols<3>() * Eigen::Vector3d(-104.0, -10.0, 600.0);
  EXPECT_FALSE(rectification(cameras, kSize));
}

TEST(Rectification, OfAnImageThatReachesTheHorizonOfTheBaseIsNone) {
  // one view looks nearly along the base at its border, 70 degrees off the other one
  std::array<ProjectionMatrix, 2> cameras = test::StereoScene(0.0).cameras;
  const Eigen::Vector3d centre = projection_centre(cameras[0]).hnormalized();
  const Eigen::Matrix3d tilted =
      cameras[0].leftCols<3>() *
      Eigen::AngleAxisd(70.0 * test::kDegree, Eigen::Vector3d::UnitY()).toRotationMatrix();
  cameras[0] << tilted, -tilted * centre;
  EXPECT_FALSE(rectification(cameras, kSize));
}

TEST(ImageFromRectified, TakesTheWayBackThroughTheLens) {
  const auto cameras = cameras_turned_by(0.0);
  const auto r = rectification(cameras, kSize);
  ASSERT_TRUE(r);
  // the distortion is half a pixel at the border of the tile
  const Eigen::Vector2d centre(3840.0, 6912.0);
  const PixelMap ideal = [&](const Eigen::Vector2d& x) {
    const Eigen::Vector2d d = x - centre;
    return std::optional<Eigen::Vector2d>(x + 1e-9 * d.squaredNorm() * d);
  };
  const cv::Rect tile(4000, 7000, 100, 50);
  const cv::Mat map = image_from_rectified(r->rectified_from_ideal[0], ideal, tile);
  ASSERT_EQ(map.size(), tile.size());
  constexpr double kCells_px = 2e-3;  // bilinear between every eighth pixel, in float
  for (const cv::Point at : {cv::Point(0, 0), cv::Point(99, 49), cv::Point(13, 21)}) {
    const auto& in_image = map.at<cv::Vec2f>(at);
    const Eigen::Vector2d back = r->rectified(0, *ideal({in_image[0], in_image[1]}));
    EXPECT_LT((back - Eigen::Vector2d(tile.x + at.x, tile.y + at.y)).norm(), kCells_px);
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
