// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/flight.h"

#include "tests/support/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::simulate {
namespace {

TEST(AerialViews, ShowsThePlanWithItsMarginAndLittleMore) {
  const SyntheticScene scene = test::gabled_house(35.0);
  FlightOptions options;
  options.seed = 4;
  for (const AerialView& view : aerial_views(scene, options)) {
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

TEST(AerialViews, HasTheGroundSamplingDistanceAndBaseOfTheBlock) {
  const SyntheticScene scene = test::flat_house();
  FlightOptions options;
  options.attitude_sigma_deg = 0.0;
  options.position_sigma_m = 0.0;
  const std::vector<AerialView> views = aerial_views(scene, options);
  EXPECT_NEAR((views[1].centre_in_local - views[0].centre_in_local).x(), 0.26 * 800.0, 1e-9);
  const auto px = [&](double x) {
    return project(views[0].image_from_local, Eigen::Vector3d(x, 20, 0));
  };
  EXPECT_NEAR((px(20.08) - px(20.0)).x(), 1.0, 1e-9);
}

TEST(AerialView, RayOfAPixelRunsThroughThePointThatItShows) {
  constexpr double kTolM = 1e-9;
  const SyntheticScene scene = test::hipped_house(30.0);
  const AerialView view = aerial_views(scene, {}).front();
  const Eigen::Vector3d x(12.0, 31.0, 4.5);
  const Eigen::Vector3d direction = view.ray(project(view.image_from_local, x));
  const Eigen::Vector3d to_point = x - view.centre_in_local;
  EXPECT_LT((to_point - to_point.dot(direction) * direction).norm(), kTolM);
  EXPECT_GT(to_point.dot(direction), 0.0);
  EXPECT_NEAR(view.pixel_angle_rad(), 1e-4, 1e-7);
}

TEST(AerialViews, DependsOnTheSeedAlone) {
  const SyntheticScene scene = test::flat_house();
  FlightOptions options;
  options.seed = 7;
  const auto first = aerial_views(scene, options);
  EXPECT_EQ(first[1].image_from_world, aerial_views(scene, options)[1].image_from_world);
  options.seed = 8;
  EXPECT_NE(first[1].image_from_world, aerial_views(scene, options)[1].image_from_world);
}

TEST(AerialViews, RefusesAnOptionOutsideItsRange) {
  FlightOptions options;
  options.base_to_height = 0.0;
  EXPECT_THROW(aerial_views(test::flat_house(), options), std::invalid_argument);
}

TEST(AerialViews, AllShowTheMiddleOfThePlanInTheMiddleOfTheImage) {
  constexpr double kTolPx = 60.0;  // position and attitude have errors, tilted views a nearer side
  const SyntheticScene scene = test::gabled_house(35.0);
  FlightOptions options;
  options.groups = {
      {ViewGroupKind::kStrip, 3}, {ViewGroupKind::kCross, 2}, {ViewGroupKind::kOblique, 4}};
  const Eigen::Vector2d middle = 0.5 * scene.extent_m;
  for (const AerialView& view : aerial_views(scene, options)) {
    const Eigen::Vector2d px = project(view.image_from_local, {middle.x(), middle.y(), 0.0});
    EXPECT_LT((px - 0.5 * view.size_px.cast<double>()).norm(), kTolPx) << view.id;
    EXPECT_GT(view.size_px.minCoeff(), 200) << view.id;
  }
}

TEST(AerialViews, ThoseOfAStripAlongYHaveNorthOnTheRight) {
  const SyntheticScene scene = test::flat_house();
  FlightOptions options;
  options.attitude_sigma_deg = options.position_sigma_m = 0.0;
  options.groups = {{ViewGroupKind::kCross, 2}};
  const AerialView view = aerial_views(scene, options).front();
  const auto px = [&](double x, double y) {
    return project(view.image_from_local, Eigen::Vector3d(x, y, 0.0));
  };
  EXPECT_NEAR((px(20.0, 20.08) - px(20.0, 20.0)).x(), 1.0, 1e-9);
  EXPECT_NEAR((px(20.08, 20.0) - px(20.0, 20.0)).y(), 1.0, 1e-9);
}

TEST(AerialViews, ObliqueOnesHaveTheFarSideOfThePlanOnTop) {
  const SyntheticScene scene = test::flat_house();
  FlightOptions options;
  options.attitude_sigma_deg = options.position_sigma_m = 0.0;
  options.groups = {{ViewGroupKind::kOblique, 4}};
  const Eigen::Vector3d middle(20.0, 20.0, 0.0);
  for (const AerialView& view : aerial_views(scene, options)) {
    const Eigen::Vector2d away = (middle - view.centre_in_local).head<2>().normalized();
    const Eigen::Vector3d farther(20.0 + away.x(), 20.0 + away.y(), 0.0);
    const Eigen::Vector2d step_px =
        project(view.image_from_local, farther) - project(view.image_from_local, middle);
    EXPECT_NEAR(step_px.x(), 0.0, 1e-6) << view.id;
    EXPECT_LT(step_px.y(), -5.0) << view.id;  // rows run down
  }
}

TEST(AerialViews, OfALongerFlightHaveErrorsOfTheirOwn) {
  const SyntheticScene scene = test::flat_house();
  FlightOptions options;
  options.base_to_height = 0.02;
  options.groups = {{ViewGroupKind::kStrip, 3}};
  const std::vector<AerialView> views = aerial_views(scene, options);
  EXPECT_EQ(views[0].number, 1U);
  EXPECT_GT(std::abs(views[0].centre_in_local.z() - views[1].centre_in_local.z()), 0.01);
  EXPECT_GT(std::abs(views[1].centre_in_local.z() - views[2].centre_in_local.z()), 0.01);
}

TEST(AerialViews, RefusesAPlanThatReachesBehindATiltedView) {
  SyntheticScene scene = test::flat_house();
  scene.extent_m = {600.0, 600.0};
  FlightOptions options;
  options.height_above_ground_m = 100.0;
  options.focal_length_px = 500.0;
  EXPECT_NO_THROW((void)aerial_views(scene, options));
  options.groups = {{ViewGroupKind::kOblique, 2}};
  options.oblique_tilt_deg = 60.0;
  EXPECT_THROW((void)aerial_views(scene, options), std::invalid_argument);
}

TEST(AerialViews, RefusesSizesOfOtherThanAllImages) {
  FlightOptions options = chio_wang_flight();
  EXPECT_NO_THROW((void)aerial_views(test::flat_house(), options));
  options.groups = {{ViewGroupKind::kStrip, 3}};
  EXPECT_THROW((void)aerial_views(test::flat_house(), options), std::invalid_argument);
}

FlightOptions frame_flight(int columns, int rows) {
  FlightOptions options;
  options.frame_px = Eigen::Vector2i(columns, rows);
  return options;
}

TEST(AerialViews, FramesAreOfOneCameraWithThePrincipalPointInTheMiddle) {
  const SyntheticScene scene = test::flat_house();
  const std::vector<AerialView> views = aerial_views(scene, frame_flight(7680, 13824));
  ASSERT_EQ(views.size(), 2U);
  for (const AerialView& view : views) {
    EXPECT_EQ(view.size_px, Eigen::Vector2i(7680, 13824));
    EXPECT_EQ(view.interior.principal_point_px, Eigen::Vector2d(3839.5, 6911.5));
    EXPECT_EQ(view.interior.focal_length_px, Eigen::Vector2d(10000.0, 10000.0));
  }
  // the base of 208 m lies between the two nadirs: the village is 1300 px right and left of the
  // middle
  EXPECT_NEAR(views[0].village_px.center().x() - views[1].village_px.center().x(), 2600.0, 300.0);
}

TEST(AerialViews, InteriorAndExteriorMakeTheMatrixOfAnyImage) {
  constexpr double kTolPx = 1e-6;  // map coordinates take 7 digits of 16
  const SyntheticScene scene = test::flat_house();
  for (const FlightOptions& options : {FlightOptions(), frame_flight(7680, 13824)}) {
    for (const AerialView& view : aerial_views(scene, options)) {
      const Eigen::Vector3d x = scene.frame.world_from_local(Eigen::Vector3d(12.0, 31.0, 4.5));
      const ProjectionMatrix P = projection_matrix(view.interior, view.exterior);
      EXPECT_LT((project(P, x) - project(view.image_from_world, x)).norm(), kTolPx);
    }
  }
}

TEST(AerialViews, OfAFrameKnowWhereTheVillageIs) {
  const SyntheticScene scene = test::gabled_house(35.0);
  for (const AerialView& view : aerial_views(scene, frame_flight(7680, 13824))) {
    Eigen::AlignedBox2d shown;
    for (const Eigen::Vector3d& x : scene.mesh.vertices) {
      shown.extend(project(view.image_from_local, x));
    }
    EXPECT_GT((shown.min() - view.village_px.min().cast<double>()).minCoeff(), 3.0);
    EXPECT_LT((shown.min() - view.village_px.min().cast<double>()).maxCoeff(), 6.0);
    EXPECT_GT((view.village_px.max().cast<double>() - shown.max()).minCoeff(), 3.0);
    EXPECT_LT((view.village_px.max().cast<double>() - shown.max()).maxCoeff(), 6.0);
  }
  const AerialView window = aerial_views(scene, {}).front();
  EXPECT_EQ(window.village_px.min(), Eigen::Vector2i(0, 0));
  EXPECT_EQ(window.village_px.max() + Eigen::Vector2i(1, 1), window.size_px);
}

std::string frame_refusal(FlightOptions options, const char* groups = "strip:2") {
  options.groups = parse_view_groups(groups);
  try {
    (void)aerial_views(test::flat_house(), options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(AerialViews, RefusesFramesThatCannotBe) {
  using ::testing::HasSubstr;
  EXPECT_EQ(frame_refusal(frame_flight(7680, 13824)), "");
  EXPECT_THAT(frame_refusal(frame_flight(99, 13824)), HasSubstr("must be in [100, 30000]"));
  EXPECT_THAT(frame_refusal(frame_flight(7680, 30001)), HasSubstr("must be in [100, 30000]"));
  EXPECT_THAT(frame_refusal(frame_flight(30000, 30000)), HasSubstr("300 megapixels"));
  EXPECT_THAT(frame_refusal(frame_flight(2000, 2000)),
              HasSubstr("left does not show the middle of the plan"));
  FlightOptions tilted = frame_flight(7680, 13824);
  EXPECT_EQ(frame_refusal(tilted, "oblique:4"), "");
  tilted.oblique_tilt_deg = 55.0;
  EXPECT_THAT(frame_refusal(tilted, "oblique:4"), HasSubstr("oblique1 looks at the horizon"));
  FlightOptions sized = chio_wang_flight();
  sized.frame_px = Eigen::Vector2i(7680, 13824);
  EXPECT_THAT(frame_refusal(sized), HasSubstr("must not both be set"));
}

TEST(HeightRange, HoldsTheSceneInWholeMetresAndIsFiftyWide) {
  const auto [low, high] = height_range_m(test::gabled_house(35.0));
  EXPECT_LE(low, -20.0);
  EXPECT_GE(high, 20.0);
  EXPECT_NEAR(high - low, 50.0, 2.0);
  EXPECT_EQ(low, std::floor(low));
}

TEST(AerialViews, RefusesImagesThatFillTheMemory) {
  SyntheticScene scene = test::flat_house();
  FlightOptions options;
  scene.extent_m = {1200.0, 1200.0};
  EXPECT_NO_THROW((void)aerial_views(scene, options));
  scene.extent_m = {1500.0, 1500.0};
  EXPECT_THROW((void)aerial_views(scene, options), std::invalid_argument);
  scene.extent_m = {2000.0, 2000.0};
  options.focal_length_px = 1e5;  // more pixels than an int counts
  EXPECT_THROW((void)aerial_views(scene, options), std::invalid_argument);
}

TEST(NominalPair, ClassesTheLinesOfATownTooLargeForImages) {
  SyntheticScene scene = test::flat_house();
  scene.extent_m = {2000.0, 2000.0};
  EXPECT_NO_THROW((void)nominal_pair(scene));
}

TEST(ClassedByViews, TakesTheLargestAngleOfAllPairs) {
  const SyntheticScene scene = test::flat_house();
  FlightOptions options;
  options.attitude_sigma_deg = options.position_sigma_m = 0.0;
  options.groups = {{ViewGroupKind::kStrip, 3}, {ViewGroupKind::kCross, 2}};
  std::vector<ProjectionMatrix> cameras;
  for (const AerialView& view : aerial_views(scene, options)) {
    cameras.push_back(view.image_from_world);
  }
  io::LineSet along_x;
  along_x.lines.emplace_back().segment_in_world = {
      scene.frame.world_from_local(Eigen::Vector3d(15.0, 20.0, 0.0)),
      scene.frame.world_from_local(Eigen::Vector3d(25.0, 20.0, 0.0))};
  const std::span strip(cameras.data(), 3);
  EXPECT_EQ(classed_by_views(along_x, strip).lines[0].line_class, "aligned");
  EXPECT_EQ(classed_by_views(along_x, cameras).lines[0].line_class, "not_aligned");
}

}  // namespace
}  // namespace ridgeline::simulate
