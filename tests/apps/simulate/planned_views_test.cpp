// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/planned_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ridgeline::simulate {
namespace {

using ::testing::ElementsAre;

constexpr double kBaseM = 0.26 * 800.0;
constexpr double kTolM = 1e-9;

std::vector<PlannedView> views_of(const char* groups) {
  FlightOptions options;
  options.groups = parse_view_groups(groups);
  return planned_views(options);
}

std::vector<std::string> ids_of(const char* groups) {
  std::vector<std::string> ids;
  for (const PlannedView& view : views_of(groups)) ids.push_back(view.id);
  return ids;
}

TEST(PlannedViews, BeginWithTheBaseAndItsNeighbour) {
  EXPECT_THAT(ids_of("strip:3"), ElementsAre("strip2", "strip3", "strip1"));
  EXPECT_THAT(ids_of("strip:4"), ElementsAre("strip2", "strip3", "strip1", "strip4"));
  EXPECT_THAT(ids_of("strip:3,cross:2"),
              ElementsAre("strip2", "strip3", "strip1", "cross1", "cross2"));
  EXPECT_THAT(ids_of("cross:2,strip:1"), ElementsAre("cross1", "cross2", "strip1"));
  EXPECT_THAT(ids_of("strip:1,cross:2"), ElementsAre("strip1", "cross1", "cross2"));
  EXPECT_THAT(ids_of("oblique:3"), ElementsAre("oblique1", "oblique2", "oblique3"));
}

TEST(PlannedViews, TwoAreLeftAndRight) {
  for (const char* groups : {"strip:2", "cross:2", "oblique:2", "strip:1,oblique:1"}) {
    EXPECT_THAT(ids_of(groups), ElementsAre("left", "right")) << groups;
  }
}

TEST(PlannedViews, AreNumberedAsTheyAreFlown) {
  std::vector<std::size_t> numbers;
  for (const PlannedView& view : views_of("strip:4,cross:1")) numbers.push_back(view.number);
  EXPECT_THAT(numbers, ElementsAre(1U, 2U, 0U, 3U, 4U));
}

TEST(PlannedViews, OfAStripStandAlongXOneBaseApart) {
  std::vector<double> x_m;
  for (const PlannedView& view : views_of("strip:5")) {
    x_m.push_back(view.from_middle_m.x());
    EXPECT_EQ(view.from_middle_m.y(), 0.0);
    EXPECT_EQ(view.from_middle_m.z(), 800.0);
    EXPECT_TRUE(view.world_from_camera_axes.isIdentity());
  }
  std::ranges::sort(x_m);
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(x_m[static_cast<std::size_t>(i)], (i - 2) * kBaseM, kTolM);
  }
}

TEST(PlannedViews, OfACrossStripAreTurnedAndStandBesideAllOfTheStrip) {
  for (const PlannedView& view : views_of("strip:3,cross:3")) {
    if (!view.id.starts_with("cross")) continue;
    const double along_bases = static_cast<double>(view.number) - 4.0;
    EXPECT_NEAR(view.from_middle_m.y(), along_bases * kBaseM, kTolM);
    EXPECT_NEAR(view.from_middle_m.x(), 0.25 * kBaseM, kTolM);
    EXPECT_EQ(view.from_middle_m.z(), 800.0);
    const Eigen::Vector3d right_in_image = view.world_from_camera_axes.col(0);
    EXPECT_TRUE(right_in_image.isApprox(Eigen::Vector3d::UnitY()));
  }
}

TEST(PlannedViews, OfAnObliqueGroupLookAtTheMiddleFromAllSides) {
  constexpr double kTiltRad = 35.0 * std::numbers::pi / 180.0;
  const std::vector<PlannedView> views = views_of("oblique:4");
  for (const PlannedView& view : views) {
    const Eigen::Vector3d back = view.world_from_camera_axes.col(2);  // cameras look along -z
    EXPECT_LT((view.from_middle_m - 800.0 * back).norm(), kTolM) << view.id;
    EXPECT_NEAR(back.z(), std::cos(kTiltRad), 1e-12) << view.id;
  }
  EXPECT_NEAR(views[0].from_middle_m.x(), views[0].from_middle_m.y(), kTolM);  // in the north-east
  EXPECT_GT(views[0].from_middle_m.x(), 0.0);
  EXPECT_NEAR(views[1].from_middle_m.x(), -views[1].from_middle_m.y(), kTolM);  // in the south-east
  EXPECT_GT(views[1].from_middle_m.x(), 0.0);
}

TEST(PlannedViews, RefuseOneView) {
  FlightOptions options;
  options.groups = {{ViewGroupKind::kStrip, 1}};
  EXPECT_THROW((void)planned_views(options), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::simulate
