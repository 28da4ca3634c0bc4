// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/houses.h"
#include "evaluate/judge/segment_plane.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ridgeline::simulate {
namespace {

using test::HouseScene;

constexpr double kRoofTol = 1e-9;  // the exactness that SyntheticScene promises

std::map<LineKind, int> count_kinds(const SyntheticScene& scene) {
  std::map<LineKind, int> counts;
  for (const SceneLine& line : scene.lines) ++counts[line.kind];
  return counts;
}

std::vector<SceneLine> of_kind(const SyntheticScene& scene, LineKind kind) {
  std::vector<SceneLine> lines;
  for (const SceneLine& line : scene.lines) {
    if (line.kind == kind) lines.push_back(line);
  }
  return lines;
}

double total_length(const std::vector<SceneLine>& lines) {
  double sum = 0.0;
  for (const SceneLine& line : lines) sum += length(line.segment);
  return sum;
}

SyntheticScene scene_of(std::vector<RoofPart> parts) {
  SyntheticScene scene;
  add_structure(parts, scene);
  return scene;
}

TEST(RoofLines, GabledHouseHasOneRidgeTwoEavesFourVerges) {
  const SyntheticScene scene = test::gabled_house(45.0);
  EXPECT_EQ(count_kinds(scene),
            (std::map<LineKind, int>{
                {LineKind::kRidge, 1}, {LineKind::kEave, 2}, {LineKind::kVerge, 4}}));
  const SceneLine ridge = of_kind(scene, LineKind::kRidge).front();
  // half a width of 4 m at 45 degrees above the wall; both verges overhang by 0.3 m
  EXPECT_NEAR(ridge.segment.start.z(), HouseScene::kWallHeightM + 4.0, kRoofTol);
  EXPECT_NEAR(ridge.segment.end.z(), HouseScene::kWallHeightM + 4.0, kRoofTol);
  EXPECT_NEAR(length(ridge.segment), HouseScene::kLengthM + 2.0 * 0.3, kRoofTol);
  EXPECT_NEAR(ridge.segment.start.y(), 20.0, kRoofTol);
  EXPECT_EQ(ridge.plane_ids.size(), 2U);
  for (const SceneLine& eave : of_kind(scene, LineKind::kEave)) {
    EXPECT_NEAR(eave.segment.start.z(), HouseScene::kWallHeightM - 0.5,
                kRoofTol);  // overhang 0.5 m
    EXPECT_EQ(eave.plane_ids.size(), 1U);
  }
  for (const SceneLine& verge : of_kind(scene, LineKind::kVerge)) {
    EXPECT_NEAR(length(verge.segment), 4.5 * std::numbers::sqrt2, kRoofTol);
  }
}

TEST(RoofLines, HippedHouseHasFourHipsThatMeetTheRidge) {
  const SyntheticScene scene = test::hipped_house(45.0, 30.0);
  EXPECT_EQ(
      count_kinds(scene),
      (std::map<LineKind, int>{{LineKind::kRidge, 1}, {LineKind::kHip, 4}, {LineKind::kEave, 4}}));
  // equal pitches: the ridge is as long as the house is longer than wide
  EXPECT_NEAR(total_length(of_kind(scene, LineKind::kRidge)), 4.0, kRoofTol);
  // a hip spans 4.5 m in u, v and z
  EXPECT_NEAR(total_length(of_kind(scene, LineKind::kHip)), 4.0 * 4.5 * std::numbers::sqrt3,
              kRoofTol);
}

TEST(RoofLines, FlatHouseHasFourEavesAtOneHeight) {
  const SyntheticScene scene = test::flat_house();
  EXPECT_EQ(count_kinds(scene), (std::map<LineKind, int>{{LineKind::kEave, 4}}));
  for (const SceneLine& eave : scene.lines) {
    EXPECT_NEAR(eave.segment.start.z(), HouseScene::kWallHeightM, kRoofTol);
  }
}

TEST(RoofLines, ParapetHasOuterAndInnerRimButNoMitres) {
  const SyntheticScene scene = scene_of(parapet({.length_m = 10.0, .width_m = 6.0}, 0.3, 0.5));
  EXPECT_EQ(count_kinds(scene), (std::map<LineKind, int>{{LineKind::kEave, 8}}));
  EXPECT_NEAR(total_length(scene.lines), 2.0 * (10.0 + 6.0) + 2.0 * (9.4 + 5.4), kRoofTol);
}

TEST(RoofLines, ShedRoofHasTwoEavesOfDifferentHeight) {
  const SyntheticScene scene =
      scene_of(shed({.width_m = 8.0, .pitch_rad = std::atan(0.25), .eave_overhang_m = 0.0}));
  const std::vector<SceneLine> eaves = of_kind(scene, LineKind::kEave);
  ASSERT_EQ(eaves.size(), 2U);
  EXPECT_NEAR(std::abs(eaves[0].segment.start.z() - eaves[1].segment.start.z()), 2.0, kRoofTol);
  EXPECT_EQ(of_kind(scene, LineKind::kVerge).size(), 2U);
}

TEST(RoofLines, WingJoinsByTwoValleysFromTheInnerCornersToItsRidge) {
  const HouseShape shape{.length_m = 14.0, .width_m = 8.0, .pitch_rad = std::numbers::pi / 4.0};
  const Wing wing{.centre_u_m = 1.0, .width_m = 6.0, .length_m = 3.0};
  const SyntheticScene scene = scene_of(l_shaped(shape, wing));
  const std::vector<SceneLine> valleys = of_kind(scene, LineKind::kValley);
  ASSERT_EQ(valleys.size(), 2U);
  const Eigen::Vector3d meeting(1.0, 1.0, 5.0 + 3.0);  // wing ridge 3 m above the walls
  for (const SceneLine& valley : valleys) {
    const bool reversed = valley.segment.start.z() > valley.segment.end.z();
    const Eigen::Vector3d top = reversed ? valley.segment.start : valley.segment.end;
    const Eigen::Vector3d foot = reversed ? valley.segment.end : valley.segment.start;
    EXPECT_LT((top - meeting).norm(), kRoofTol);
    EXPECT_NEAR(std::abs(foot.x() - 1.0), 3.4, kRoofTol);  // both eaves overhang by 0.4 m
    EXPECT_NEAR(foot.y(), 4.4, kRoofTol);
    EXPECT_NEAR(foot.z(), 4.6, kRoofTol);
  }
  // two ridges; the eave of the main roof is interrupted by the wing
  EXPECT_EQ(of_kind(scene, LineKind::kRidge).size(), 2U);
  EXPECT_NEAR(total_length(of_kind(scene, LineKind::kEave)),
              2.0 * 14.6 - 6.8 + 2.0 * (3.0 + 0.3 - 0.4), kRoofTol);
}

TEST(RoofLines, DormerCutsNothingOfTheMainRidgeAndHidesItsInnerEnd) {
  const HouseShape shape{.length_m = 12.0, .width_m = 9.0, .pitch_rad = 0.8};
  std::vector<RoofPart> parts = gabled(shape);
  const double main_ridge_z = ridge_z_m(shape);
  parts.push_back(dormer(shape, {.type = DormerType::kGabled}));
  const SyntheticScene scene = scene_of(parts);
  std::vector<SceneLine> ridges = of_kind(scene, LineKind::kRidge);
  ASSERT_EQ(ridges.size(), 2U);
  std::sort(ridges.begin(), ridges.end(),
            [](const auto& a, const auto& b) { return a.segment.start.z() < b.segment.start.z(); });
  EXPECT_NEAR(length(ridges[1].segment), 12.6, kRoofTol);
  EXPECT_LT(ridges[0].segment.start.z(), main_ridge_z);
  // the dormer's ridge ends on the main roof plane
  const double inner_v = std::min(ridges[0].segment.start.y(), ridges[0].segment.end.y());
  EXPECT_NEAR(ridges[0].segment.start.z(), main_ridge_z - std::tan(0.8) * inner_v, kRoofTol);
  EXPECT_EQ(of_kind(scene, LineKind::kValley).size(), 2U);
  EXPECT_GE(scene.joints.size(), 1U);  // its walls on the main roof
}

TEST(RoofLines, ShedDormerHasOneValleyWhereItRunsIntoTheRoof) {
  const HouseShape shape{.length_m = 12.0, .width_m = 9.0, .pitch_rad = 0.8};
  std::vector<RoofPart> parts = gabled(shape);
  parts.push_back(dormer(shape, {.type = DormerType::kShed, .pitch_rad = 0.4}));
  const std::vector<SceneLine> valleys = of_kind(scene_of(parts), LineKind::kValley);
  ASSERT_EQ(valleys.size(), 1U);
  EXPECT_NEAR(valleys.front().segment.start.z(), valleys.front().segment.end.z(), kRoofTol);
  EXPECT_NEAR(length(valleys.front().segment), 2.0 + 2.0 * 0.15, kRoofTol);
}

TEST(RoofLines, ChimneyInterruptsTheRidgeItStandsOn) {
  const HouseShape shape{.length_m = 10.0, .verge_overhang_m = 0.0};
  std::vector<RoofPart> parts = gabled(shape);
  parts.push_back(chimney(shape, 0.0, 0.0, 0.5));
  const SyntheticScene scene = scene_of(parts);
  const std::vector<SceneLine> ridges = of_kind(scene, LineKind::kRidge);
  ASSERT_EQ(ridges.size(), 2U);
  EXPECT_NEAR(total_length(ridges), 10.0 - 0.8, 1e-6);   // a chimney is 0.8 m long
  EXPECT_EQ(count_kinds(scene).at(LineKind::kEave), 2);  // it has no lines itself
}

TEST(Placed, TurnsAndMovesPlanesWithTheirOutline) {
  const RoofPart part = gabled({}).front();
  const RoofPart moved = placed(part, {100.0, -20.0}, 0.7);
  for (std::size_t i = 0; i < part.outline.size(); ++i) {
    for (std::size_t k = 0; k < part.tops.size(); ++k) {
      EXPECT_NEAR(moved.tops[k](moved.outline[i]), part.tops[k](part.outline[i]), kRoofTol);
    }
  }
}

TEST(TrueMeanDistance, AveragesThePlanesOfARidge) {
  const SyntheticScene scene = test::gabled_house(45.0);
  const auto ridge = std::find_if(scene.lines.begin(), scene.lines.end(),
                                  [](const auto& line) { return line.kind == LineKind::kRidge; });
  ASSERT_NE(ridge, scene.lines.end());
  const int id = static_cast<int>(ridge - scene.lines.begin());
  EXPECT_NEAR(true_mean_distance(scene, ridge->segment, id), 0.0, kRoofTol);
  Segment3 lifted = ridge->segment;
  lifted.start.z() += 6.0;
  lifted.end.z() += 6.0;
  EXPECT_NEAR(true_mean_distance(scene, lifted, id), 6.0 * std::cos(std::numbers::pi / 4.0),
              kRoofTol);
  Segment3 aside = ridge->segment;  // leaves one plane downwards, the other upwards
  aside.start.y() += 1.0;
  aside.end.y() += 1.0;
  EXPECT_NEAR(true_mean_distance(scene, aside, id), std::sqrt(0.5), kRoofTol);
}

TEST(TrueMeanDistance, RejectsAnUnknownLine) {
  const SyntheticScene scene = test::gabled_house(45.0);
  EXPECT_THROW(true_mean_distance(scene, {}, -1), std::invalid_argument);
  EXPECT_THROW(true_mean_distance(scene, {}, 7), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::simulate
