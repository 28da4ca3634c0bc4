// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/pair_check/pair_fit.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kLimit_px = 3.0;
constexpr double kExact_px = 1e-6;  // rounding of a few thousand pixels in double
const std::array<Eigen::Vector2i, 2> kSizes{Eigen::Vector2i(1000, 800), Eigen::Vector2i(900, 700)};

/// Two cameras 800 m up and 200 m apart, the right one turned and tilted a little, so that no two
/// readings agree.
PairGeometry oblique_pair() {
  PairGeometry geometry;
  geometry.heights_m = {0.0, 30.0};
  const std::array<Eigen::Vector3d, 2> centres{Eigen::Vector3d(0, 0, 800),
                                               Eigen::Vector3d(180, 60, 760)};
  for (std::size_t i = 0; i < 2; ++i) {
    const double tilt = i == 0 ? 0.05 : -0.08;
    const double turn = i == 0 ? 0.1 : 0.35;
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(tilt, Eigen::Vector3d(1, 0.5, 0).normalized()))
            .toRotationMatrix() *
        Eigen::Vector3d(1, -1, -1).asDiagonal();
    Eigen::Matrix3d k = Eigen::Matrix3d::Identity();
    k.diagonal() << 6000, 6000, 1;
    ProjectionMatrix p;
    p << rotation, -rotation * centres[i];
    p = k * p;
    const Eigen::Vector2d ground = project(p, Eigen::Vector3d(90, 20, 10));
    Eigen::Matrix3d window = Eigen::Matrix3d::Identity();
    window.col(2).head<2>() = 0.5 * kSizes[i].cast<double>() - ground;
    geometry.image_from_local[i] = window * p;
  }
  return geometry;
}

std::vector<PointMatch> true_points(const PairGeometry& geometry) {
  cv::RNG random(7);
  std::vector<PointMatch> points;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d x(90 + random.uniform(-40.0, 40.0), 20 + random.uniform(-30.0, 30.0),
                            random.uniform(2.0, 28.0));
    points.push_back(
        {{project(geometry.image_from_local[0], x), project(geometry.image_from_local[1], x)}});
  }
  return points;
}

TEST(FitOfPair, IsExactForTruePoints) {
  const PairGeometry geometry = oblique_pair();
  const PairFit fit = fit_of_pair(true_points(geometry), geometry, kLimit_px);
  EXPECT_EQ(fit.n_points, 200U);
  EXPECT_LT(fit.median_y_parallax_px, kExact_px);
  EXPECT_EQ(fit.share_that_fits, 1.0);
}

TEST(FitOfPair, MeasuresTheDistanceAcrossTheEpipolarLineInBothImages) {
  PairGeometry geometry;  // epipolar lines are rows; one pixel across in either image
  geometry.heights_m = {0.0, 30.0};
  geometry.image_from_local[0] << 6000, 0, 0, 0, 0, -6000, 0, 0, 0, 0, -1, 800;
  geometry.image_from_local[1] << 6000, 0, 0, -1200000, 0, -6000, 0, 0, 0, 0, -1, 800;
  std::vector<PointMatch> points = true_points(geometry);
  for (PointMatch& match : points) match.x_px[1].y() += 4.5;
  const PairFit fit = fit_of_pair(points, geometry, kLimit_px);
  EXPECT_NEAR(fit.median_y_parallax_px, 4.5, kExact_px);
  EXPECT_EQ(fit.share_that_fits, 0.0);
  EXPECT_EQ(fit_of_pair(points, geometry, 5.0).share_that_fits, 1.0);
}

TEST(FitOfPair, PointsOutsideOfTheHeightsDoNotFit) {
  PairGeometry geometry = oblique_pair();
  const std::vector<PointMatch> points = true_points(geometry);
  geometry.heights_m = {100.0, 130.0};
  const PairFit fit = fit_of_pair(points, geometry, kLimit_px);
  EXPECT_LT(fit.median_y_parallax_px, kExact_px);
  EXPECT_EQ(fit.share_that_fits, 0.0);
}

TEST(FitOfPair, LeavesOutWhatTheCameraCannotHaveSeenAndHasNoMedianOfNothing) {
  PairGeometry geometry = oblique_pair();
  const std::vector<PointMatch> points = true_points(geometry);
  geometry.ideal_from_image[1] = [](const Eigen::Vector2d&) -> std::optional<Eigen::Vector2d> {
    return std::nullopt;
  };
  const PairFit fit = fit_of_pair(points, geometry, kLimit_px);
  EXPECT_EQ(fit.n_points, 0U);
  EXPECT_TRUE(std::isnan(fit.median_y_parallax_px));
}

/// Where the point lies in a file that was made from the camera's image by turning and scaling it.
Eigen::Vector2d in_file(Eigen::Vector2d x_px, Eigen::Vector2i size, int turned_deg, double scale) {
  for (int angle = 0; angle < turned_deg; angle += 90) {  // a quarter clockwise
    x_px = {size.y() - 1 - x_px.y(), x_px.x()};
    std::swap(size.x(), size.y());
  }
  return ((x_px.array() + 0.5) * scale - 0.5).matrix();
}

TEST(FittingReadings, NameHowTheFilesWereMade) {
  const PairGeometry geometry = oblique_pair();
  std::vector<PairReading> readings;
  for (const int angle : {90, 180, 270}) {
    readings.push_back({.turned_deg = {angle, angle}});
    readings.push_back({.turned_deg = {0, angle}});
  }
  for (const double scale : {0.5, 2.0}) {
    readings.push_back({.scale = {scale, scale}});
    readings.push_back({.scale = {scale, 1.0}});
  }
  for (const PairReading& made : readings) {
    std::array<Eigen::Vector2i, 2> sizes = kSizes;
    std::vector<PointMatch> points = true_points(geometry);
    for (std::size_t i = 0; i < 2; ++i) {
      for (PointMatch& match : points) {
        match.x_px[i] = in_file(match.x_px[i], kSizes[i], made.turned_deg[i], made.scale[i]);
      }
      if (made.turned_deg[i] % 180 != 0) std::swap(sizes[i].x(), sizes[i].y());
      sizes[i] = (sizes[i].cast<double>() * made.scale[i]).cast<int>();
    }
    EXPECT_LT(fit_of_pair(points, geometry, kLimit_px).share_that_fits, 1.0);
    const auto fitting = fitting_readings(points, sizes, geometry, kLimit_px);
    ASSERT_EQ(fitting.size(), 1U) << made.turned_deg[1] << " " << made.scale[0];
    EXPECT_FALSE(fitting[0].swapped);
    EXPECT_EQ(fitting[0].turned_deg, made.turned_deg);
    EXPECT_EQ(fitting[0].scale, made.scale);
  }
}

TEST(FittingReadings, NameSwappedImages) {
  const PairGeometry geometry = oblique_pair();
  std::vector<PointMatch> points = true_points(geometry);
  for (PointMatch& match : points) std::swap(match.x_px[0], match.x_px[1]);
  const auto fitting = fitting_readings(points, {kSizes[1], kSizes[0]}, geometry, kLimit_px);
  ASSERT_EQ(fitting.size(), 1U);
  EXPECT_TRUE(fitting[0].swapped);
}

TEST(FittingReadings, AreNoneForPointsAtRandom) {
  const PairGeometry geometry = oblique_pair();
  cv::RNG random(3);
  std::vector<PointMatch> points(100);
  for (PointMatch& match : points) {
    for (auto& x_px : match.x_px) x_px = {random.uniform(0.0, 900.0), random.uniform(0.0, 700.0)};
  }
  EXPECT_TRUE(fitting_readings(points, kSizes, geometry, kLimit_px).empty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
