// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/aerial_pair.h"

#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace ridgeline::simulate {
namespace {

TEST(AerialPair, ShowsThePlanWithItsMarginAndLittleMore) {
  const Scene scene = test::gabled_house(35.0);
  FlightOptions options;
  options.seed = 4;
  for (const AerialView& view : aerial_pair(scene, options)) {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
    Eigen::Vector2d high = -low;
    for (const double x : {-options.margin_m, scene.extent_m.x() + options.margin_m}) {
      for (const double y : {-options.margin_m, scene.extent_m.y() + options.margin_m}) {
        const Eigen::Vector2d px = project(view.image_from_local, Eigen::Vector3d(x, y, 0.0));
        low = low.cwiseMin(px);
        high = high.cwiseMax(px);
      }
    }
    EXPECT_GE(low.minCoeff(), 0.0);
    EXPECT_LT(low.maxCoeff(), 1.0);
    EXPECT_LE((high - view.size_px.cast<double>()).maxCoeff(), -1.0 + 1e-9);
    EXPECT_GT((high - view.size_px.cast<double>()).minCoeff(), -2.5);
  }
}

TEST(AerialPair, HasTheGroundSamplingDistanceAndBaseOfTheBlock) {
  const Scene scene = test::flat_house();
  FlightOptions options;
  options.attitude_sigma_deg = 0.0;
  options.position_sigma_m = 0.0;
  const std::array<AerialView, 2> views = aerial_pair(scene, options);
  EXPECT_NEAR((views[1].centre_in_local - views[0].centre_in_local).x(), 0.26 * 800.0, 1e-9);
  const auto px = [&](double x) {
    return project(views[0].image_from_local, Eigen::Vector3d(x, 20, 0));
  };
  EXPECT_NEAR((px(20.08) - px(20.0)).x(), 1.0, 1e-9);
}

TEST(AerialView, RayOfAPixelRunsThroughThePointThatItShows) {
  constexpr double kTolM = 1e-9;
  const Scene scene = test::hipped_house(30.0);
  const AerialView view = aerial_pair(scene, {}).front();
  const Eigen::Vector3d x(12.0, 31.0, 4.5);
  const Eigen::Vector3d direction = view.ray(project(view.image_from_local, x));
  const Eigen::Vector3d to_point = x - view.centre_in_local;
  EXPECT_LT((to_point - to_point.dot(direction) * direction).norm(), kTolM);
  EXPECT_GT(to_point.dot(direction), 0.0);
  EXPECT_NEAR(view.pixel_angle_rad(), 1e-4, 1e-7);
}

TEST(AerialPair, DependsOnTheSeedAlone) {
  const Scene scene = test::flat_house();
  FlightOptions options;
  options.seed = 7;
  const auto first = aerial_pair(scene, options);
  EXPECT_EQ(first[1].image_from_world, aerial_pair(scene, options)[1].image_from_world);
  options.seed = 8;
  EXPECT_NE(first[1].image_from_world, aerial_pair(scene, options)[1].image_from_world);
}

TEST(AerialPair, RefusesAnOptionOutsideItsRange) {
  FlightOptions options;
  options.base_to_height = 0.0;
  EXPECT_THROW(aerial_pair(test::flat_house(), options), std::invalid_argument);
}

TEST(HeightRange, HoldsTheSceneInWholeMetresAndIsFiftyWide) {
  const auto [low, high] = height_range_m(test::gabled_house(35.0));
  EXPECT_LE(low, -20.0);
  EXPECT_GE(high, 20.0);
  EXPECT_NEAR(high - low, 50.0, 2.0);
  EXPECT_EQ(low, std::floor(low));
}

TEST(AerialPair, RefusesImagesThatFillTheMemory) {
  Scene scene = test::flat_house();
  FlightOptions options;
  scene.extent_m = {1200.0, 1200.0};
  EXPECT_NO_THROW((void)aerial_pair(scene, options));
  scene.extent_m = {1500.0, 1500.0};
  EXPECT_THROW((void)aerial_pair(scene, options), std::invalid_argument);
  scene.extent_m = {2000.0, 2000.0};
  options.focal_length_px = 1e5;  // more pixels than an int counts
  EXPECT_THROW((void)aerial_pair(scene, options), std::invalid_argument);
}

TEST(NominalPair, ClassesTheLinesOfATownTooLargeForImages) {
  Scene scene = test::flat_house();
  scene.extent_m = {2000.0, 2000.0};
  EXPECT_NO_THROW((void)nominal_pair(scene));
}

}  // namespace
}  // namespace ridgeline::simulate
