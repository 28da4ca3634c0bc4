// SPDX-License-Identifier: BSD-3-Clause
// What a model lacks of a scan, and where lines are expected to show it.
#include "evaluate/files/model_lacks.h"

#include "evaluate/files/scan_scope.h"

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::results {
namespace {

std::vector<Eigen::Vector3d> rectangle(double x_m, double width_m, double height_m) {
  return {{x_m, 0.0, height_m},
          {x_m + width_m, 0.0, height_m},
          {x_m + width_m, 10.0, height_m},
          {x_m, 10.0, height_m}};
}

/// Two flat roofs of 10 m by 10 m, at x = 0 and x = 30.
io::LineSet two_roofs() {
  io::BuildingModel model;
  model.buildings.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    model.faces.push_back({.rings = {rectangle(30.0 * static_cast<double>(i), 10.0, 5.0)},
                           .kind = FaceKind::kRoof,
                           .building = i,
                           .id = ""});
  }
  io::LineSet set;
  set.model = std::make_shared<const io::BuildingModel>(std::move(model));
  return set;
}

evaluate::ScanPlane roof_of_scan(double x_m, double width_m) {
  evaluate::ScanPlane plane;
  plane.rings = {rectangle(x_m, width_m, 5.0)};
  plane.fit.centroid = {x_m + 0.5 * width_m, 5.0, 5.0};
  plane.area_m2 = 10.0 * width_m;
  plane.is_roof = true;
  return plane;
}

evaluate::ScanScope everywhere() {
  return {.contains = [](const Eigen::Vector2d&) { return true; }};
}

std::vector<MissingRoof> missing_of(const evaluate::ScanPlane& plane,
                                    const evaluate::ScanScope& scope = everywhere()) {
  const ModelPlan plan(two_roofs(), {}, {});
  return missing_roofs(plan, {.planes = {plane}, .edges = {}}, scope);
}

TEST(MissingRoofs, AreThoseOfWhichLessThanHalfLiesOnBuildings) {
  EXPECT_TRUE(missing_of(roof_of_scan(0.0, 10.0)).empty());
  EXPECT_TRUE(missing_of(roof_of_scan(4.0, 10.0)).empty());
  const std::vector<MissingRoof> beside = missing_of(roof_of_scan(6.0, 10.0));
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_NEAR(beside[0].explained, 0.4, 0.03);
  EXPECT_EQ(beside[0].area_m2, 100.0);
  EXPECT_EQ(beside[0].middle, Eigen::Vector3d(11.0, 5.0, 5.0));
}

TEST(MissingRoofs, AreRoofsOf20SquareMetresInTheArea) {
  EXPECT_EQ(missing_of(roof_of_scan(15.0, 2.0)).size(), 1U);
  EXPECT_TRUE(missing_of(roof_of_scan(15.0, 1.9)).empty());
  evaluate::ScanPlane ground = roof_of_scan(15.0, 10.0);
  ground.is_roof = false;
  EXPECT_TRUE(missing_of(ground).empty());
  const evaluate::ScanScope nowhere{.contains = [](const Eigen::Vector2d&) { return false; }};
  EXPECT_TRUE(missing_of(roof_of_scan(15.0, 10.0), nowhere).empty());
}

evaluate::ScanEdge scan_edge(double x_m, double y_m) {
  return {.segment = {{x_m, y_m, 5.0}, {x_m + 4.0, y_m, 5.0}},
          .kind = "step",
          .planes = {0},
          .support = 1.0};
}

TEST(MissingEdges, BelongToTheNearestBuildingWithin1Metre) {
  const evaluate::ScanEdges scan{.planes = {roof_of_scan(0.0, 10.0)},
                                 .edges = {scan_edge(2.0, 0.0), scan_edge(2.0, -0.9),
                                           scan_edge(2.0, -1.1), scan_edge(33.0, 4.0)}};
  JudgedModel judged;
  judged.rows.resize(2);
  judged.places = {0, 1};
  const std::vector<Segment3> lines{{{2.0, 0.0, 5.0}, {6.0, 0.0, 5.0}}};
  count_missing_edges(ModelPlan(two_roofs(), {}, {}), scan, lines, judged);
  EXPECT_EQ(judged.rows[0].scan_edges->n, 2);
  EXPECT_EQ(judged.rows[0].scan_edges->n_missing, 1);
  EXPECT_EQ(judged.rows[1].scan_edges->n, 1);
  EXPECT_EQ(judged.rows[1].scan_edges->n_missing, 1);
}

TEST(ModelPlan, MovesWithTheLines) {
  evaluate::Evaluation evaluation;
  evaluate::ConstantShift shift;
  shift.applied = true;
  shift.shift_m = {-10.0, 0.0, 0.0};
  evaluation.shift = shift;
  EXPECT_FALSE(ModelPlan(two_roofs(), {}, {}).covers({15.0, 5.0}));
  EXPECT_TRUE(ModelPlan(two_roofs(), evaluation, {}).covers({15.0, 5.0}));
}

JudgedFiles one_judged_line() {
  JudgedFiles judged;
  evaluate::LineEvaluation line;
  line.status = evaluate::Status::kEvaluated;
  line.segment = {{0.0, 0.0, 5.0}, {10.0, 0.0, 5.0}};
  evaluate::LineEvaluation far = line;
  far.status = evaluate::Status::kNoLidar;
  far.segment = {{1000.0, 0.0, 5.0}, {1010.0, 0.0, 5.0}};
  judged.evaluations.emplace_back().lines = {line, far};
  return judged;
}

TEST(ScanArea, IsTheHullOfTheJudgedLinesAnd5MetresAroundIt) {
  const ScanArea area = scan_area(one_judged_line(), {});
  EXPECT_EQ(area.scope.area_from, "lines");
  EXPECT_TRUE(area.scope.contains({5.0, 4.9}));
  EXPECT_FALSE(area.scope.contains({5.0, 5.1}));
  EXPECT_TRUE(area.scope.contains({-4.9, 0.0}));
  EXPECT_FALSE(area.scope.contains({500.0, 0.0}));
  EXPECT_NEAR(area.scope.area_m2, 2 * 10.0 * 5.0 + 78.54, 0.01);
  EXPECT_EQ(area.box_m.max().x(), 15.0);
  EXPECT_FALSE(area.scope.is_shown);
}

TEST(ScanArea, OfNoLinesIsEmpty) {
  const ScanArea area = scan_area({}, {});
  EXPECT_TRUE(area.box_m.isEmpty());
  EXPECT_FALSE(area.scope.contains({0.0, 0.0}));
}

TEST(ScanArea, IsTheStatedOneWithoutItsUpperSides) {
  JudgeFilesOptions options;
  options.area = Eigen::AlignedBox2d(Eigen::Vector2d(100.0, 0.0), Eigen::Vector2d(120.0, 10.0));
  JudgedFiles judged = one_judged_line();
  judged.frame.origin_m = {100.0, 0.0, 0.0};
  const ScanArea area = scan_area(judged, options);
  EXPECT_EQ(area.scope.area_from, "stated");
  EXPECT_TRUE(area.scope.contains({0.0, 0.0}));
  EXPECT_FALSE(area.scope.contains({20.0, 5.0}));
  EXPECT_EQ(area.scope.area_m2, 200.0);
}

/// A camera 100 m above the ground at (x, 0) that looks down, with 0.1 m a pixel on the ground.
io::PatchImage camera_above(double x_m) {
  io::PatchImage image;
  image.image_from_world << 1000.0, 0.0, -100.0, 10000.0 - 1000.0 * x_m,  //
      0.0, -1000.0, -100.0, 10000.0,                                      //
      0.0, 0.0, -1.0, 100.0;
  image.window = io::Window{0, 0, 200, 200};
  return image;
}

TEST(ScanArea, IsWhatTheFirstImageShows) {
  JudgeFilesOptions options;
  io::Patch& patch = options.patch.emplace();
  patch.images = {camera_above(0.0), camera_above(8.0)};
  patch.height_range_m = {0.0, 0.0};
  const ScanArea area = scan_area(one_judged_line(), options);
  EXPECT_EQ(area.scope.area_from, "images");
  EXPECT_NEAR(area.scope.area_m2, 400.0, 1.0);
  EXPECT_TRUE(area.scope.contains({-9.0, 9.0}));
  EXPECT_FALSE(area.scope.contains({11.0, 0.0}));
  ASSERT_TRUE(area.scope.is_shown);
  EXPECT_TRUE(area.scope.is_shown({{-1.0, 0.0, 0.0}, {9.0, 0.0, 0.0}}));
  EXPECT_FALSE(area.scope.is_shown({{-3.0, 0.0, 0.0}, {9.0, 0.0, 0.0}}));
  EXPECT_FALSE(area.scope.is_shown({{0.0, 0.0, 200.0}, {5.0, 0.0, 200.0}}));
}

TEST(ScanArea, OfABlockIsStatedInItsReferenceSystem) {
  JudgeFilesOptions options;
  options.patch.emplace().images = {camera_above(0.0), camera_above(8.0)};
  options.block_area_m = {{100.0, 0.0}, {110.0, 0.0}, {100.0, 10.0}};
  JudgedFiles judged;
  judged.frame.origin_m = {100.0, 0.0, 0.0};
  const ScanArea area = scan_area(judged, options);
  EXPECT_EQ(area.scope.area_from, "block");
  EXPECT_EQ(area.scope.area_m2, 50.0);
  EXPECT_TRUE(area.scope.contains({4.0, 4.0}));
  EXPECT_FALSE(area.scope.contains({6.0, 6.0}));
}

}  // namespace
}  // namespace ridgeline::results
