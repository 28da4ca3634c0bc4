// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/orientation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace ridgeline {
namespace {

constexpr double kPixelTolerance = 1e-9;
constexpr double kHalfTurnRad = std::numbers::pi;

InteriorOrientation some_interior() {
  InteriorOrientation interior;
  interior.focal_length_px = {10000.0, 10010.0};
  interior.principal_point_px = {3800.0, 6900.0};
  interior.distortion = {-0.05, 0.01, -0.002, 0.0004, -0.0003};
  return interior;
}

TEST(InteriorOrientationOfFrame, CountsPixelsFromTheCentreOfTheTopLeftOne) {
  const InteriorOrientation interior = interior_orientation(120.0, 12.0, {7680, 13824}, {0.0, 0.0});
  EXPECT_DOUBLE_EQ(interior.focal_length_px.x(), 10000.0);
  EXPECT_DOUBLE_EQ(interior.focal_length_px.y(), 10000.0);
  EXPECT_DOUBLE_EQ(interior.principal_point_px.x(), 3839.5);
  EXPECT_DOUBLE_EQ(interior.principal_point_px.y(), 6911.5);
}

TEST(InteriorOrientationOfFrame, MovesThePrincipalPointRightAndUp) {
  const InteriorOrientation interior = interior_orientation(100.0, 10.0, {101, 51}, {0.05, 0.02});
  EXPECT_DOUBLE_EQ(interior.principal_point_px.x(), 50.0 + 5.0);
  EXPECT_DOUBLE_EQ(interior.principal_point_px.y(), 25.0 - 2.0);
}

TEST(InteriorOrientationOfFrame, RejectsWhatIsNotPositive) {
  EXPECT_THROW(interior_orientation(0.0, 12.0, {10, 10}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(interior_orientation(120.0, -1.0, {10, 10}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(interior_orientation(120.0, std::nan(""), {10, 10}, {0, 0}), std::invalid_argument);
  EXPECT_THROW(interior_orientation(120.0, 12.0, {10, 0}, {0, 0}), std::invalid_argument);
}

TEST(WorldFromCameraAxes, TurnsInTheOrderOmegaPhiKappa) {
  // Large angles by hand: kappa = 90 deg takes x to y, omega = 90 deg then takes y to z.
  const Eigen::Matrix3d R = world_from_camera_axes(kHalfTurnRad / 2, 0.0, kHalfTurnRad / 2);
  EXPECT_TRUE((R * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE((R * Eigen::Vector3d::UnitY()).isApprox(-Eigen::Vector3d::UnitX()));
  // phi = 90 deg takes x to -z, omega = 90 deg then takes -z to y.
  const Eigen::Matrix3d S = world_from_camera_axes(kHalfTurnRad / 2, kHalfTurnRad / 2, 0.0);
  EXPECT_TRUE((S * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY()));
}

TEST(ProjectionMatrixOfOrientation, LooksDownWithRowsRunningSouth) {
  InteriorOrientation interior;
  interior.focal_length_px = {1000.0, 1000.0};
  interior.principal_point_px = {500.0, 400.0};
  const ExteriorOrientation nadir{{100.0, 200.0, 1000.0}, Eigen::Matrix3d::Identity()};
  const ProjectionMatrix P = projection_matrix(interior, nadir);
  const Eigen::Vector3d x(110.0, 220.0, 0.0);  // 10 m east, 20 m north, 1000 m below
  EXPECT_TRUE(project(P, x).isApprox(Eigen::Vector2d(510.0, 380.0), kPixelTolerance));
  EXPECT_DOUBLE_EQ((P * x.homogeneous()).z(), 1000.0);
}

TEST(ProjectionMatrixOfOrientation, HasTheProjectionCentreAtThePosition) {
  const ExteriorOrientation exterior{{513000.0, 5403000.0, 1250.0},
                                     world_from_camera_axes(0.3, -0.2, 2.0)};
  const ProjectionMatrix P = projection_matrix(some_interior(), exterior);
  const Eigen::Vector3d centre = -P.leftCols<3>().inverse() * P.col(3);
  constexpr double kToleranceM = 1e-4;  // rounding of 5e6 m times the matrix's condition, 1e4
  EXPECT_LT((centre - exterior.position_m).norm(), kToleranceM);
}

TEST(WindowFromWorld, SubtractsTheWindowFromThePixel) {
  const ProjectionMatrix P =
      projection_matrix(some_interior(), {{1.0, 2.0, 100.0}, world_from_camera_axes(0.1, 0.2, 3)});
  const Eigen::Vector3d x(5.0, -7.0, 3.0);
  const Eigen::Vector2d window(1500.0, 320.0);
  EXPECT_LT((project(window_from_world(P, window), x) - (project(P, x) - window)).norm(),
            kPixelTolerance);
}

TEST(DistortedPx, AgreesWithTheFormulaByHand) {
  InteriorOrientation interior;
  interior.focal_length_px = {100.0, 100.0};
  interior.principal_point_px = {10.0, 20.0};
  interior.distortion = {0.1, 0.02, 0.003, 0.01, 0.05};
  // x = 1, y = 2, r2 = 5: radial = 1 + 0.5 + 0.5 + 0.375 = 2.375;
  // x_d = 2.375 + 2 * 0.01 * 2 + 0.05 * (5 + 2) = 2.765;
  // y_d = 4.75 + 0.01 * (5 + 8) + 2 * 0.05 * 2 = 5.08.
  const Eigen::Vector2d actual = distorted_px(interior, {110.0, 220.0});
  EXPECT_NEAR(actual.x(), 10.0 + 276.5, kPixelTolerance);
  EXPECT_NEAR(actual.y(), 20.0 + 508.0, kPixelTolerance);
}

TEST(UndistortedPx, InvertsTheDistortionOverTheWholeImage) {
  const InteriorOrientation interior = some_interior();
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> column(0.0, 7679.0);
  std::uniform_real_distribution<double> row(0.0, 13823.0);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector2d ideal(column(rng), row(rng));
    const auto actual = undistorted_px(interior, distorted_px(interior, ideal));
    ASSERT_TRUE(actual.has_value());
    EXPECT_LT((*actual - ideal).norm(), kPixelTolerance);
  }
}

TEST(UndistortedPx, HasNoAnswerBeyondTheFoldOfThePolynomial) {
  InteriorOrientation interior;
  interior.focal_length_px = {1000.0, 1000.0};
  interior.distortion.k1 = -0.5;  // radii grow to 0.544 only, at r = 0.816
  EXPECT_TRUE(undistorted_px(interior, {500.0, 0.0}).has_value());
  EXPECT_FALSE(undistorted_px(interior, {600.0, 0.0}).has_value());
}

}  // namespace
}  // namespace ridgeline
