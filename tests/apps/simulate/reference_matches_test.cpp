// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/reference_matches.h"

#include "apps/simulate/fittings.h"
#include "apps/simulate/mesh_builder.h"
#include "apps/simulate/physical_edges.h"
#include "apps/simulate/village.h"
#include "tests/apps/simulate/observed_scene.h"
#include "tests/support/scene.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace ridgeline::simulate {
namespace {

constexpr std::size_t kLeft = 0;
constexpr std::size_t kRight = 1;

/// A level square of 4 m at height `z`.
SyntheticScene level_plate(double z) {
  SyntheticScene scene;
  scene.extent_m = {20.0, 20.0};
  add_polygon({{8, 8, z}, {12, 8, z}, {12, 12, z}, {8, 12, z}}, {kNone, kNone, Material::kWall},
              scene.mesh);
  return scene;
}

/// Least distance to the planes of the triangles that a point lies over or under; leaves left out.
double distance_to(const Mesh& mesh, const Eigen::Vector3d& x) {
  double least = 1e9;
  for (const Triangle& triangle : mesh.triangles) {
    if (triangle.material == Material::kFoliage) continue;
    const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& {
      return mesh.vertices[static_cast<std::size_t>(triangle.vertices[i % 3])];
    };
    const Eigen::Vector3d n = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const double distance = std::abs(n.dot(x - corner(0))) / n.norm();
    if (!(distance < least)) continue;
    constexpr double kBorder = -1e-9;
    const auto inside = [&](std::size_t i) {
      return n.dot((corner(i + 1) - corner(i)).cross(x - corner(i))) >= kBorder;
    };
    if (inside(0) && inside(1) && inside(2)) least = distance;
  }
  return least;
}

TEST(PhysicalEdges, JoinsPiecesOfOneLineAndLeavesOutDiagonals) {
  SyntheticScene scene;
  scene.extent_m = {20.0, 20.0};
  for (const double x : {2.0, 6.0, 10.0}) {  // three tiles in a row
    add_polygon({{x, 5, 0}, {x + 4, 5, 0}, {x + 4, 7, 0}, {x, 7, 0}},
                {kNone, kNone, Material::kStreet}, scene.mesh);
  }
  std::multiset<double> lengths;
  for (const PhysicalEdge& edge : physical_edges(scene)) {
    lengths.insert(std::round(1000.0 * length(edge.segment)) / 1000.0);
  }
  EXPECT_EQ(lengths, (std::multiset<double>{2.0, 2.0, 2.0, 2.0, 12.0, 12.0}));
}

TEST(PhysicalEdges, PutsTheFootOfAWallOnTheGround) {
  const SyntheticScene scene =
      test::gabled_house(35.0);  // its walls go down to -1 m, the ground is at 0
  int feet = 0;
  for (const PhysicalEdge& edge : physical_edges(scene)) {
    EXPECT_GE(std::max(edge.segment.start.z(), edge.segment.end.z()), 0.0);
    const bool level = edge.segment.start.z() == 0.0 && edge.segment.end.z() == 0.0;
    feet += edge.kind == "wall" && level ? 1 : 0;
  }
  EXPECT_EQ(feet, 4);
}

TEST(VisibleRuns, EndAtAnOccludingBody) {
  SyntheticScene scene = level_plate(0.5);
  add_polygon({{9, 7, 6.0}, {10, 7, 6.0}, {10, 13, 6.0}, {9, 13, 6.0}},
              {kNone, kNone, Material::kRoof}, scene.mesh);
  FlightOptions flight;
  flight.attitude_sigma_deg = flight.position_sigma_m = 0.0;
  const std::vector<AerialView> views = aerial_views(scene, flight);
  const SurfaceOracle oracle(scene, views);
  const Segment3 edge{{8, 8, 0.5}, {12, 8, 0.5}};
  const auto runs = visible_runs(oracle, kLeft, edge);
  ASSERT_EQ(runs.size(), 2U);
  // the camera 94 m to the left and 800 m up looks under the strip from x + 5.5 * 94 / 794
  const double shift_m = (9.0 - views[0].centre_in_local.x()) * 5.5 / 794.0;
  constexpr double kStepM = 0.11;  // of the lines of sight
  EXPECT_NEAR(4.0 * runs[0].end, 1.0 + shift_m, kStepM);
  EXPECT_NEAR(4.0 * runs[1].begin, 2.0 + shift_m, kStepM);
}

TEST(VisibleRuns, AreEmptyWhereBothSidesAreOneSurface) {
  SyntheticScene scene;
  scene.extent_m = {20.0, 20.0};
  for (const double x : {4.0, 10.0}) {
    add_polygon({{x, 5, 0}, {x + 6, 5, 0}, {x + 6, 15, 0}, {x, 15, 0}},
                {kNone, kNone, Material::kStreet}, scene.mesh);
  }
  const SurfaceOracle oracle(scene, aerial_views(scene, {}));
  EXPECT_TRUE(visible_runs(oracle, kLeft, {{10, 5, 0}, {10, 15, 0}}).empty());
  EXPECT_EQ(visible_runs(oracle, kLeft, {{4, 5, 0}, {4, 15, 0}}).size(), 1U);
}

TEST(ReferenceMatches, HoldTheRoofOfAHouse) {
  const test::ObservedScene o = test::observed(test::gabled_house(35.0, 20.0));
  const SurfaceOracle oracle(o.scene, o.views);
  std::map<std::string, int> kinds;
  for (const ReferenceEdge& match : reference_matches(test::measured_edges(o, oracle))) {
    ++kinds[match.kind];
  }
  EXPECT_EQ(kinds["ridge"], 1);
  EXPECT_EQ(kinds["eave"], 2);
  EXPECT_EQ(kinds["verge"], 4);
}

TEST(ReferenceMatches, ShowOneSurfaceInBothImages) {
  constexpr double kTolPx = 0.3;
  VillageOptions options;
  options.seed = 3;
  options.extent_m = {60.0, 60.0};
  SyntheticScene village = make_village(options);
  add_fittings(village, 3);
  const test::ObservedScene o = test::observed(std::move(village));
  const SurfaceOracle oracle(o.scene, o.views);
  const auto matches = reference_matches(test::measured_edges(o, oracle));
  ASSERT_GT(matches.size(), 50U);
  std::size_t good = 0;
  for (const ReferenceEdge& match : matches) {
    EXPECT_GE(std::min(length(match.base), length(match.other)), 10.0) << match.kind;
    const VisibleVerdict verdict = judge_match(oracle, match.base, match.other);
    good += verdict.right_distance_px < kTolPx ? 1 : 0;
  }
  // in the rest another body hides both flanks in one view
  EXPECT_GE(static_cast<double>(good), 0.98 * static_cast<double>(matches.size()));
}

TEST(JudgeMatch, TellsAFalsePairAndAShadowEdge) {
  const SyntheticScene scene = level_plate(4.0);
  const std::vector<AerialView> views = aerial_views(scene, {});
  const SurfaceOracle oracle(scene, views);
  const auto in = [&](std::size_t view, const Segment3& s) {
    return project(views[view].image_from_local, s);
  };
  const Segment3 edge{{8, 12, 4}, {12, 12, 4}};
  const VisibleVerdict good = judge_match(oracle, in(kLeft, edge), in(kRight, edge));
  EXPECT_LT(good.right_distance_px, 0.05);
  EXPECT_GT(good.overlap_share, 0.95);

  const Segment3 other{{8, 12.5, 4}, {12, 12.5, 4}};
  EXPECT_GT(judge_match(oracle, in(kLeft, edge), in(kRight, other)).right_distance_px, 5.0);
  const Segment3 beyond{{14, 12, 4}, {18, 12, 4}};
  EXPECT_LT(judge_match(oracle, in(kLeft, edge), in(kRight, beyond)).overlap_share, 0.05);
  const Segment3 shadow{{3, 5, 0}, {7, 6, 0}};  // any line on the lawn
  EXPECT_LT(judge_match(oracle, in(kLeft, shadow), in(kRight, shadow)).right_distance_px, 0.05);
}

TEST(SurfaceOracle, FindsTheCounterpartOfAPixelUnlessItIsHidden) {
  const SyntheticScene scene = level_plate(4.0);
  const std::vector<AerialView> views = aerial_views(scene, {});
  const SurfaceOracle oracle(scene, views);
  const Eigen::Vector3d on_plate(9.0, 9.5, 4.0);
  const auto counterpart = oracle.counterpart_of(kLeft, kRight, oracle.pixel_of(kLeft, on_plate));
  ASSERT_TRUE(counterpart);
  EXPECT_LT((*counterpart - oracle.pixel_of(kRight, on_plate)).norm(), 1e-6);
  // the plate, 4 m up, hides 0.5 m of the ground beside it from the camera on its other side
  const Eigen::Vector3d beside(7.9, 10.0, 0.0);
  const auto seen = oracle.seen_at(kLeft, oracle.pixel_of(kLeft, beside));
  ASSERT_TRUE(seen);
  EXPECT_LT((seen->x - beside).norm(), 1e-6);
  EXPECT_FALSE(oracle.visible(kRight, beside));
  EXPECT_FALSE(oracle.counterpart_of(kLeft, kRight, oracle.pixel_of(kLeft, beside)));
  EXPECT_TRUE(oracle.visible(kRight, {7.3, 10.0, 0.0}));
  EXPECT_FALSE(oracle.visible(kLeft, {500.0, 0.0, 0.0}));  // not in the image
}

TEST(SurfaceOracle, FollowsAPixelBetweenAnyTwoViews) {
  constexpr double kTolPx = 1e-6;
  const SyntheticScene scene = level_plate(4.0);
  FlightOptions flight;
  flight.groups = {{ViewGroupKind::kStrip, 2}, {ViewGroupKind::kOblique, 2}};
  const SurfaceOracle oracle(scene, aerial_views(scene, flight));
  ASSERT_EQ(oracle.num_views(), 4U);
  const Eigen::Vector3d on_plate(9.0, 9.5, 4.0);
  for (std::size_t from = 0; from < oracle.num_views(); ++from) {
    for (std::size_t to = 0; to < oracle.num_views(); ++to) {
      const auto counterpart = oracle.counterpart_of(from, to, oracle.pixel_of(from, on_plate));
      ASSERT_TRUE(counterpart);
      EXPECT_LT((*counterpart - oracle.pixel_of(to, on_plate)).norm(), kTolPx) << from << " " << to;
    }
  }
}

TEST(VisibleShares, AreOneForTheRidgeOfALonelyHouse) {
  const SyntheticScene scene = test::gabled_house(35.0);
  const SurfaceOracle oracle(scene, aerial_views(scene, {}));
  const auto shares = visible_shares(scene, oracle);
  ASSERT_EQ(shares.size(), scene.lines.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (scene.lines[i].kind != LineKind::kRidge) continue;
    EXPECT_NEAR(shares[i][0], 1.0, 0.02);
    EXPECT_NEAR(shares[i][1], 1.0, 0.02);
  }
}

TEST(Fittings, StayWithinTwelveCentimetresOfTheMeshAndChangeNoLine) {
  VillageOptions options;
  options.seed = 6;
  options.extent_m = {60.0, 60.0};
  const SyntheticScene bare = make_village(options);
  SyntheticScene scene = bare;
  add_fittings(scene, 6);
  ASSERT_GT(scene.mesh.triangles.size(), bare.mesh.triangles.size() + 200);
  EXPECT_EQ(scene.lines.size(), bare.lines.size());
  EXPECT_EQ(scene.planes.size(), bare.planes.size());
  constexpr double kMaxDistanceM = 0.12 + 1e-6;
  constexpr std::size_t kEvery = 11;  // of the new vertices, for the test's speed
  for (std::size_t i = bare.mesh.vertices.size(); i < scene.mesh.vertices.size(); i += kEvery) {
    EXPECT_LE(distance_to(bare.mesh, scene.mesh.vertices[i]), kMaxDistanceM) << i;
  }
  SyntheticScene again = bare;
  add_fittings(again, 6);
  EXPECT_EQ(again.mesh.vertices, scene.mesh.vertices);
}

}  // namespace
}  // namespace ridgeline::simulate
