// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/ball_cover.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kRounding_m = 1e-9;  // rounding of coordinates of 100 m in double

Eigen::AlignedBox3d hills() {
  return {Eigen::Vector3d(-50, -50, 200), Eigen::Vector3d(50, 50, 320)};
}

Eigen::Vector3d point_in(const Eigen::AlignedBox3d& box, test::Random& random) {
  Eigen::Vector3d x;
  for (int i = 0; i < 3; ++i) x(i) = random.uniform(box.min()(i), box.max()(i));
  return x;
}

TEST(BallCover, HoldsEveryPointOfTheCorridorInTheBallThatIsItsOwn) {
  test::Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Segment2 line{point_in(hills(), random).head<2>(), point_in(hills(), random).head<2>()};
    const double radius_m = random.uniform(0.3, 8.0);
    const BallCover cover(line, radius_m, hills());
    for (int k = 0; k < 200; ++k) {
      const Eigen::Vector3d x = point_in(hills(), random);
      if (distance(line, Eigen::Vector2d(x.head<2>())) > radius_m) continue;
      const Ball ball = cover.ball(cover.ball_of(x));
      EXPECT_LE((x - ball.centre).norm(), ball.radius_m + kRounding_m) << "trial " << trial;
    }
  }
}

TEST(BallCover, HasBallsLittleWiderThanTheCorridor) {
  const BallCover cover({{-30, 0}, {30, 0}}, 4.0, hills());
  EXPECT_EQ(cover.size(), 9 * 15);  // 68 m along and 120 m of height in steps of at most 8 m
  EXPECT_LE(cover.ball(0).radius_m, 4.0 * std::sqrt(3.0));
}

TEST(BallCover, HasOneRowOfBallsOverAPlace) {
  const BallCover cover({{1, 2}, {1, 2}}, 4.0, hills());
  EXPECT_EQ(cover.ball(0).centre.x(), cover.ball(cover.size() - 1).centre.x());
}

TEST(BallCover, HasNoBallBesideTheExtent) {
  EXPECT_EQ(BallCover({{-30, 60}, {30, 60}}, 4.0, hills()).size(), 0);
  EXPECT_EQ(BallCover({{60, 0}, {90, 0}}, 4.0, hills()).size(), 0);
  EXPECT_EQ(BallCover({{1e300, -1e300}, {1e300, -1e300}}, 4.0, hills()).size(), 0);
  EXPECT_EQ(BallCover({{0, 0}, {1, 0}}, 4.0, Eigen::AlignedBox3d()).size(), 0);
}

TEST(BallCover, StaysSmallForABirdFarAboveTheCloud) {
  Eigen::AlignedBox3d extent = hills();
  extent.extend(Eigen::Vector3d(0, 0, 1e7));
  constexpr int kMaxBalls = 256 * 256;
  EXPECT_LE(BallCover({{-1e7, 0}, {1e7, 0}}, 0.3, extent).size(), kMaxBalls);
}

TEST(BallCover, TakesALevelCloudAndNoRadius) {
  const Eigen::AlignedBox3d level(Eigen::Vector3d(0, 0, 5), Eigen::Vector3d(9, 9, 5));
  const Eigen::Vector3d x(3, 3, 5);
  for (const double radius_m : {0.0, 1.0}) {
    const BallCover cover({{3, 3}, {3, 3}}, radius_m, level);
    const Ball ball = cover.ball(cover.ball_of(x));
    EXPECT_LE((x - ball.centre).norm(), ball.radius_m + kRounding_m);
  }
}

}  // namespace
}  // namespace ridgeline::evaluate
