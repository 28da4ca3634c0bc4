// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/surface.h"

#include "tests/reconstruct/support/painted_roofs.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace ridgeline::reconstruct {
namespace {

const Eigen::AlignedBox2d kSurfaceHouse(Eigen::Vector2d(-6.0, -5.0), Eigen::Vector2d(6.0, 5.0));

/// A sloping roof over flat ground.
test::PaintedRoofs scene() {
  return {.faces = {{.plan = kSurfaceHouse, .height_m = 6.0, .slope = 0.3}}};
}

struct Errors {
  double known = 0.0, median_px = 0.0, beyond_half_px = 0.0;
};

/// The errors of what both views show, away from the border of the image.
Errors errors_of(const test::PaintedRoofs& roofs, const StereoPair& pair, const Surface& surface) {
  std::vector<double> errors;
  std::size_t n = 0;
  const ProjectionMatrix& left = pair.views[0]->image_from_local;
  const ProjectionMatrix& right = pair.views[1]->image_from_local;
  for (int row = 40; row < roofs.size_px - 40; row += 3) {
    for (int column = 40; column < roofs.size_px - 40; column += 3) {
      const Eigen::Vector2d x(column, row);
      const Eigen::Vector3d truth = roofs.seen(left, x);
      const Eigen::Vector3d in_right = roofs.seen(right, project(right, truth));
      if ((in_right - truth).norm() > 1e-6) continue;  // the right view does not see it
      ++n;
      const Rectification& r = surface.rectification;
      if (const auto d = surface.at(r.rectified(0, x)))
        errors.push_back(std::abs(*d - r.disparity_px(truth)));
    }
  }
  std::ranges::sort(errors);
  const auto beyond = errors.end() - std::ranges::upper_bound(errors, 0.5);
  const auto n_known = static_cast<double>(errors.size());
  return {n_known / static_cast<double>(n), errors[errors.size() / 2],
          static_cast<double>(beyond) / n_known};
}

constexpr double kMedian_px =
    0.15;  // steps of 1/16 px, and the nearest pixel is up to half a pixel off on a slope
constexpr double kKnown = 0.9;
constexpr double kBeyond = 0.08;  // errors beside the steps of the roof

TEST(DenseSurface, KnowsRoofAndGround) {
  const test::PaintedRoofs roofs = scene();
  const test::OwnedPair pair = roofs.pair();
  const auto surface = dense_surface(pair);
  ASSERT_TRUE(surface);
  const Errors e = errors_of(roofs, pair, *surface);
  EXPECT_GT(e.known, kKnown);
  EXPECT_LT(e.median_px, kMedian_px);
  EXPECT_LT(e.beyond_half_px, kBeyond);
}

TEST(DenseSurface, IsAsGoodForTurnedViews) {
  for (const double turn_deg : {90.0, 180.0}) {
    test::PaintedRoofs roofs = scene();
    roofs.right_turn_rad = turn_deg * test::kDegree;
    const test::OwnedPair pair = roofs.pair();
    const auto surface = dense_surface(pair);
    ASSERT_TRUE(surface);
    const Errors e = errors_of(roofs, pair, *surface);
    EXPECT_GT(e.known, kKnown) << turn_deg;
    EXPECT_LT(e.median_px, kMedian_px) << turn_deg;
  }
}

TEST(DenseSurface, IsTheSameForAnyNumberOfThreads) {
  const test::OwnedPair pair = scene().pair();
  constexpr int kTile_px = 128;
  const auto many = dense_surface(pair, kTile_px);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = dense_surface(pair, kTile_px);
  ASSERT_TRUE(many && single);
  ASSERT_EQ(many->disparity_px.size(), single->disparity_px.size());
  EXPECT_EQ(std::memcmp(many->disparity_px.data, single->disparity_px.data,
                        many->disparity_px.total() * sizeof(float)),
            0);
}

TEST(DenseSurface, HardlyDependsOnTheTiles) {
  test::PaintedRoofs roofs = scene();
  roofs.size_px = 500;
  const test::OwnedPair pair = roofs.pair();
  const auto whole = dense_surface(pair);
  const auto tiles = dense_surface(pair, 256);
  ASSERT_TRUE(whole && tiles);
  std::size_t n = 0;
  std::size_t n_apart = 0;
  for (int row = 0; row < whole->disparity_px.rows; ++row) {
    for (int column = 0; column < whole->disparity_px.cols; ++column) {
      const float a = whole->disparity_px.at<float>(row, column);
      const float b = tiles->disparity_px.at<float>(row, column);
      if (std::isnan(a) || std::isnan(b)) continue;
      ++n;
      if (std::abs(a - b) > 0.1F) ++n_apart;
    }
  }
  EXPECT_LT(static_cast<double>(n_apart), 0.01 * static_cast<double>(n));
}

TEST(DenseSurface, TakesAnyRangeOfHeights) {
  const test::PaintedRoofs roofs = scene();
  test::OwnedPair pair = roofs.pair();
  pair.height_range_in_local_m = {-300.0, 300.0};  // thousands of disparities
  const auto wide = dense_surface(pair);
  ASSERT_TRUE(wide);
  EXPECT_GT(errors_of(roofs, pair, *wide).known, kKnown);
  pair.height_range_in_local_m = {-300.0, 799.0};  // up to the cameras
  const auto endless = dense_surface(pair);
  ASSERT_TRUE(endless);
  EXPECT_EQ(cv::countNonZero(endless->disparity_px == endless->disparity_px), 0);
}

/// A surface of 8 x 6 pixels, one of which is not known.
Surface small_surface() {
  const Eigen::Matrix3d no_turn = Eigen::Matrix3d::Identity();
  const Rectification r{.rectified_from_ideal = {no_turn, no_turn},
                        .rectified_from_local = no_turn,
                        .left_centre_m = Eigen::Vector3d::Zero(),
                        .principal_point_px = Eigen::Vector2d::Zero(),
                        .focal_px = 1.0,
                        .base_m = 1.0,
                        .size = {8, 6}};
  cv::Mat disparity_px(r.size, CV_32F, cv::Scalar(1.0));
  disparity_px.at<float>(2, 4) = std::numeric_limits<float>::quiet_NaN();
  return {r, disparity_px};
}

TEST(PointsInLocal, AreThoseOfAllKnownPixelsRowByRow) {
  const Surface surface = small_surface();
  const std::vector<Eigen::Vector3d> points = points_in_local(surface);
  ASSERT_EQ(points.size(), 8U * 6U - 1U);
  EXPECT_EQ(points[1], surface.rectification.point_in_local({1.0, 0.0}, 1.0));
  EXPECT_EQ(points.back(), surface.rectification.point_in_local({7.0, 5.0}, 1.0));
}

TEST(PointsInLocal, AreThinnedByTheSmallestStepOfRowsAndColumns) {
  const Surface surface = small_surface();
  EXPECT_EQ(points_in_local(surface, 48).size(), 47U);
  for (const std::size_t most : {47U, 12U}) {  // every second row and column are 4 x 3
    const std::vector<Eigen::Vector3d> points = points_in_local(surface, most);
    ASSERT_EQ(points.size(), 11U) << most;
    EXPECT_EQ(points[5], surface.rectification.point_in_local({2.0, 2.0}, 1.0));
    EXPECT_EQ(points[6], surface.rectification.point_in_local({6.0, 2.0}, 1.0));
  }
  EXPECT_EQ(points_in_local(surface, 11).size(), 6U);  // every third: 3 x 2
  EXPECT_EQ(points_in_local(surface, 1).size(), 1U);
}

TEST(PointsInLocal, CannotBeThinnedToNone) {
  EXPECT_THROW((void)points_in_local(small_surface(), 0), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
