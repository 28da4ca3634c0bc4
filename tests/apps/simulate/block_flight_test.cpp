// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/block_flight.h"

#include "apps/simulate/village.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::simulate {
namespace {

using ::testing::HasSubstr;

/// Frames of 160 x 120 m from 200 m, without errors.
FlightOptions exact_flight() {
  FlightOptions flight;
  flight.frame_px = Eigen::Vector2i(1600, 1200);
  flight.focal_length_px = 2000.0;
  flight.height_above_ground_m = 200.0;
  flight.position_sigma_m = 0.0;
  flight.attitude_sigma_deg = 0.0;
  return flight;
}

/// A plan without a village on ground that rises to the east.
SyntheticScene bare_plan(double slope) {
  SyntheticScene scene;
  scene.extent_m = {100.0, 80.0};
  scene.mean_terrain.gradient = {slope, 0.0};
  scene.mean_terrain.offset = -0.5 * slope * scene.extent_m.x();
  return scene;
}

Eigen::AlignedBox2d plan_area_m(double x_min, double y_min, double x_max, double y_max) {
  return {Eigen::Vector2d(x_min, y_min), Eigen::Vector2d(x_max, y_max)};
}

Eigen::Vector3d to_the_right_in_the_image(const PlannedView& view) {
  return view.world_from_camera_axes.col(0);
}

TEST(BlockViews, StandAlongXWithTheOverlapsThereAndBack) {
  constexpr double kTol = 1e-9;
  constexpr double kBase_m = 0.4 * 160.0;
  constexpr double kSpacing_m = 0.7 * 120.0;
  constexpr double kSlope = 0.1;
  const std::vector<PlannedView> views = block_views({}, exact_flight(), bare_plan(kSlope));
  ASSERT_EQ(views.size(), 6U);
  const std::vector<const char*> ids{"01_01", "01_02", "01_03", "02_01", "02_02", "02_03"};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(views[i].id, ids[i]);
    EXPECT_EQ(views[i].number, i);
    const double along = static_cast<double>(i % 3) - 1.0;
    const double x_m = (i < 3 ? along : -along) * kBase_m;
    const Eigen::Vector3d expected(x_m, (i < 3 ? -0.5 : 0.5) * kSpacing_m, 200.0 + kSlope * x_m);
    EXPECT_LT((views[i].from_middle_m - expected).norm(), kTol) << views[i].id;
    const Eigen::Vector3d flown = i < 3 ? Eigen::Vector3d(1, 0, 0) : Eigen::Vector3d(-1, 0, 0);
    EXPECT_LT((to_the_right_in_the_image(views[i]) - flown).norm(), kTol) << views[i].id;
  }
}

TEST(BlockViews, OfCrossingStripsCountOnAndShowTwiceWhatTheStripsShow) {
  BlockOptions block;
  block.num_cross_strips = 2;
  const std::vector<PlannedView> views = block_views(block, exact_flight(), bare_plan(0.0));
  // 204 m along y: two frames each show 160 + (n - 3) 64 m
  constexpr std::size_t kFramesOfAStrip = 4;
  ASSERT_EQ(views.size(), 6 + 2 * kFramesOfAStrip);
  EXPECT_EQ(views[6].id, "03_01");
  EXPECT_EQ(views.back().id, "04_04");
  EXPECT_NEAR(views[7].from_middle_m.y() - views[6].from_middle_m.y(), 64.0, 1e-9);
  EXPECT_NEAR(views[6].from_middle_m.x() - views[10].from_middle_m.x(), 84.0, 1e-9);
  EXPECT_NEAR(views[6].from_middle_m.x() + views[10].from_middle_m.x(), 2 * 16.0, 1e-9);
  EXPECT_TRUE(to_the_right_in_the_image(views[6]).isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_TRUE(to_the_right_in_the_image(views[10]).isApprox(-Eigen::Vector3d::UnitY()));
}

TEST(BlockExtent, IsWhatTwoFramesShowOfTheHighestObjects) {
  // a frame shows 15 / 200 less of what is 15 m high
  EXPECT_EQ(block_extent_m({}, exact_flight(), 0.0), Eigen::Vector2d(160.0 - 12.0, 204.0 - 9.0));
  BlockOptions two;
  two.num_frames = 2;
  EXPECT_EQ(block_extent_m(two, exact_flight(), 0.0), Eigen::Vector2d(84.0, 195.0));
}

TEST(BlockExtent, OfAnyFlightHoldsAVillageThatAllIsShownTwice) {
  FlightOptions flight = exact_flight();
  flight.position_sigma_m = 2.0;
  flight.attitude_sigma_deg = 0.4;
  VillageOptions village;
  village.extent_m = block_extent_m({}, flight, village.terrain_slope_deg);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    flight.seed = village.seed = seed;
    const SyntheticScene scene = make_village(village);
    const std::vector<AerialView> views =
        aerial_views(scene, flight, block_views({}, flight, scene));
    EXPECT_NO_THROW(check_shown_twice(scene, views, {Eigen::Vector2d::Zero(), scene.extent_m}));
  }
}

std::string refusal_of_block(const BlockOptions& block, const FlightOptions& flight) {
  try {
    (void)block_extent_m(block, flight, 0.0);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(BlockExtent, RefusesABlockThatCannotBe) {
  const auto refusal_of = [](int strips, int frames) {
    BlockOptions block;
    block.num_strips = strips;
    block.num_frames = frames;
    return refusal_of_block(block, exact_flight());
  };
  EXPECT_EQ(refusal_of(2, 3), "");
  EXPECT_THAT(refusal_of(0, 3), HasSubstr("strips of a block = 0, must be in [1, 99]"));
  EXPECT_THAT(refusal_of(100, 3), HasSubstr("strips of a block = 100"));
  EXPECT_THAT(refusal_of(2, 1), HasSubstr("frames of a strip = 1, must be in [2, 99]"));
  EXPECT_THAT(refusal_of(2, 100), HasSubstr("frames of a strip = 100"));
  EXPECT_THAT(refusal_of(99, 2), HasSubstr("must be 40 to 2000 m each"));
  FlightOptions no_frames = exact_flight();
  no_frames.frame_px.reset();
  EXPECT_THAT(refusal_of_block({}, no_frames), HasSubstr("must have whole frames"));
  BlockOptions no_overlap;
  no_overlap.forward_overlap = 0.4;
  EXPECT_THAT(refusal_of_block(no_overlap, exact_flight()), HasSubstr("forward_overlap = 0.4"));
}

TEST(CheckShownTwice, NamesAPlaceThatOneFrameShows) {
  const FlightOptions flight = exact_flight();
  const SyntheticScene scene = bare_plan(0.0);
  const std::vector<AerialView> views = aerial_views(scene, flight, block_views({}, flight, scene));
  // the middle of the block is that of the plan, at (50, 40) m; 160 x 204 m are shown twice, to
  // half a pixel
  EXPECT_NO_THROW(check_shown_twice(scene, views, plan_area_m(-29.9, -61.9, 129.9, 141.9)));
  for (const Eigen::AlignedBox2d& area :
       {plan_area_m(-31.0, 0.0, 50.0, 40.0), plan_area_m(0.0, 0.0, 131.0, 40.0),
        plan_area_m(0.0, -63.0, 50.0, 40.0), plan_area_m(0.0, 0.0, 50.0, 143.0)}) {
    EXPECT_THROW(check_shown_twice(scene, views, area), std::invalid_argument);
  }
  try {
    check_shown_twice(scene, views, plan_area_m(-31.0, 0.0, 50.0, 40.0));
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("the place -31, 0 m from the corner of the plan"));
    EXPECT_THAT(error.what(), HasSubstr("shown by 1 frames"));
  }
}

TEST(CheckShownTwice, LooksAtTheHighestObjectsToo) {
  const FlightOptions flight = exact_flight();
  SyntheticScene scene = bare_plan(0.0);
  const std::vector<AerialView> views = aerial_views(scene, flight, block_views({}, flight, scene));
  const Eigen::AlignedBox2d area_m = plan_area_m(-25.0, -55.0, 125.0, 135.0);
  EXPECT_NO_THROW(check_shown_twice(scene, views, area_m));
  scene.mesh.vertices = {{50.0, 40.0, 30.0}};
  EXPECT_THROW(check_shown_twice(scene, views, area_m), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::simulate
