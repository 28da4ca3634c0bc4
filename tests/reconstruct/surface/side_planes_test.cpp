// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/side_planes.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <limits>

namespace ridgeline::reconstruct {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr double kPlane_px = 1e-5;  // disparities are float
const Segment2 kPlaneLine{{50.0, 60.0}, {110.0, 80.0}};

/// A surface of the given disparities.
template <typename DisparityAt>
Surface surface_of(const DisparityAt& disparity_at) {
  Surface surface;
  surface.disparity_px = cv::Mat(150, 200, CV_32F);
  for (int row = 0; row < surface.disparity_px.rows; ++row) {
    for (int column = 0; column < surface.disparity_px.cols; ++column) {
      surface.disparity_px.at<float>(row, column) =
          static_cast<float>(disparity_at(Eigen::Vector2d(column, row)));
    }
  }
  return surface;
}

/// Pixels beside the line, positive towards its normal.
double beside(const Eigen::Vector2d& x) { return normal(kPlaneLine).dot(x - kPlaneLine.start); }

TEST(SidePlane, OfAStepIsThatOfEitherSide) {
  const Surface surface =
      surface_of([](const Eigen::Vector2d& x) { return beside(x) > 0.0 ? 40.0 : 25.0; });
  const auto towards = side_plane(surface, kPlaneLine, 1);
  const auto away = side_plane(surface, kPlaneLine, -1);
  ASSERT_TRUE(towards && away);
  EXPECT_NEAR(towards->on_line(0.0), 40.0, kPlane_px);
  EXPECT_NEAR(away->on_line(10.0), 25.0, kPlane_px);
  EXPECT_EQ(towards->share, 1.0);
}

TEST(SidePlane, IsExtendedToTheLineAlongItsSlope) {
  constexpr double kPriorOfSlope_px = 0.05;  // slopes are expected to be small
  const Surface surface = surface_of([](const Eigen::Vector2d& x) {
    return 30.0 + 0.1 * along(kPlaneLine).dot(x - midpoint(kPlaneLine)) + 0.2 * beside(x);
  });
  const auto plane = side_plane(surface, kPlaneLine, 1);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->on_line(0.0), 30.0, kPriorOfSlope_px);
  EXPECT_NEAR(plane->on_line(20.0), 32.0, kPriorOfSlope_px);
}

TEST(SidePlane, IsThatOfMostPixels) {
  test::Random random(3);
  const Surface surface = surface_of([&](const Eigen::Vector2d&) {
    return random.uniform(0.0, 1.0) < 0.3 ? random.uniform(0.0, 60.0) : 33.0 + random.normal(0.1);
  });
  const auto plane = side_plane(surface, kPlaneLine, -1);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->on_line(0.0), 33.0, 0.1);
  EXPECT_LT(plane->share, 0.8);
}

TEST(SidePlane, IsKnownBetterBesideALongLineAndWorseWhereItScatters) {
  constexpr double kDrawn = 0.2;  // share by which random numbers move the scatter
  const auto variance_px2 = [](double scatter_px, const Segment2& line) {
    test::Random random(4);
    const Surface surface =
        surface_of([&](const Eigen::Vector2d&) { return 30.0 + random.normal(scatter_px); });
    return side_plane(surface, line, 1)->cov(0, 0);
  };
  const Segment2 half{point_at(kPlaneLine, 0.25), point_at(kPlaneLine, 0.75)};
  const double expected_px2 = variance_px2(0.1, kPlaneLine);
  EXPECT_NEAR(variance_px2(0.1, half) / expected_px2, 2.0, 2.0 * kDrawn);
  EXPECT_NEAR(variance_px2(0.2, kPlaneLine) / expected_px2, 4.0, 4.0 * kDrawn);
}

TEST(SidePlane, OfAHiddenSideIsNone) {
  const Surface surface =
      surface_of([](const Eigen::Vector2d& x) { return beside(x) > 0.0 ? 40.0F : kNaN; });
  EXPECT_TRUE(side_plane(surface, kPlaneLine, 1));
  EXPECT_FALSE(side_plane(surface, kPlaneLine, -1));
}

TEST(SidePlane, OutsideOfTheImageIsNone) {
  const Surface surface = surface_of([](const Eigen::Vector2d&) { return 40.0; });
  const Eigen::Vector2d aside(0.0, 500.0);
  EXPECT_FALSE(side_plane(surface, {kPlaneLine.start + aside, kPlaneLine.end + aside}, 1));
}

TEST(SidesAlong, AreThoseOfPiecesOf30px) {
  const Surface surface =
      surface_of([](const Eigen::Vector2d& x) { return beside(x) > 0.0 ? 40.0 : 25.0; });
  const std::vector<SidesOfPiece> pieces = sides_along(surface, kPlaneLine);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].parameters[1], pieces[1].parameters[0]);
  EXPECT_NEAR(pieces[1].length_px, 0.5 * length(kPlaneLine), kPlane_px);
  for (const SidesOfPiece& piece : pieces) {
    ASSERT_TRUE(piece.planes[0] && piece.planes[1]);
    EXPECT_NEAR(piece.planes[0]->on_line(0.0), 40.0, kPlane_px);
    EXPECT_NEAR(piece.planes[1]->on_line(0.0), 25.0, kPlane_px);
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
