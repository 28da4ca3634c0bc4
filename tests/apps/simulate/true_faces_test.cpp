// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/true_faces.h"

#include "apps/simulate/houses.h"
#include "apps/simulate/village.h"
#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ridgeline::simulate {
namespace {

using ::testing::ElementsAre;
using Corners = std::vector<Eigen::Vector3d>;

constexpr double kFaceTol_m = 1e-5;  // vertices nearer than 1e-6 are merged; Boost rounds to 1e-7

std::vector<Face> faces_of(std::vector<RoofPart> parts) {
  SyntheticScene scene;
  add_structure(parts, scene);
  return scene.faces;
}

std::vector<Face> of_surface(const std::vector<Face>& faces, FaceKind kind) {
  std::vector<Face> found;
  std::ranges::copy_if(faces, std::back_inserter(found),
                       [&](const Face& face) { return face.kind == kind; });
  return found;
}

/// Twice the area of a ring as a vector along its normal (Newell).
Eigen::Vector3d area_vector(const Corners& ring) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += (ring[i] - ring[0]).cross(ring[(i + 1) % ring.size()] - ring[0]);
  return sum;
}

double face_area(const Face& face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Corners& ring : face.rings) sum += area_vector(ring);  // holes run the other way
  return 0.5 * sum.norm();
}

double total_area(const std::vector<Face>& faces) {
  double sum = 0.0;
  for (const Face& face : faces) sum += face_area(face);
  return sum;
}

std::vector<std::size_t> corner_counts(const std::vector<Face>& faces) {
  std::vector<std::size_t> counts;
  for (const Face& face : faces) counts.push_back(face.rings[0].size());
  std::ranges::sort(counts);
  return counts;
}

bool covers(const Face& face, const Eigen::Vector2d& x) {
  bool inside = false;
  for (const Corners& ring : face.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector3d& a = ring[i];
      const Eigen::Vector3d& b = ring[(i + 1) % ring.size()];
      if ((a.y() > x.y()) == (b.y() > x.y())) continue;
      if (x.x() < a.x() + (b.x() - a.x()) * (x.y() - a.y()) / (b.y() - a.y())) inside = !inside;
    }
  }
  return inside;
}

double height_at(const Face& face, const Eigen::Vector2d& x) {
  const Eigen::Vector3d n = area_vector(face.rings[0]);
  const Eigen::Vector3d& a = face.rings[0][0];
  return a.z() - (n.x() * (x.x() - a.x()) + n.y() * (x.y() - a.y())) / n.z();
}

double distance_to_border(const Face& face, const Eigen::Vector3d& x) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Corners& ring : face.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector3d& a = ring[i];
      const Eigen::Vector3d along = ring[(i + 1) % ring.size()] - a;
      const double t = std::clamp(along.dot(x - a) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (a + t * along - x).norm());
    }
  }
  return nearest;
}

SyntheticScene village_of_all_types(std::uint64_t seed) {
  VillageOptions options;
  options.seed = seed;
  options.built_share = 1.0;
  options.trees_per_lot = 0.0;
  options.annex_share = 0.5;
  options.dormer_share = 0.5;
  return make_village(options);
}

TEST(TrueFaces, AGabledHouseHasTwoRoofsFourWallsAndAGround) {
  HouseShape shape;
  shape.pitch_rad = 0.5;
  const std::vector<Face> faces = faces_of(gabled(shape));
  const auto roofs = of_surface(faces, FaceKind::kRoof);
  const auto walls = of_surface(faces, FaceKind::kWall);
  EXPECT_THAT(corner_counts(roofs), ElementsAre(4U, 4U));
  EXPECT_THAT(corner_counts(walls), ElementsAre(4U, 4U, 5U, 5U));
  EXPECT_THAT(corner_counts(of_surface(faces, FaceKind::kGround)), ElementsAre(4U));
  EXPECT_NEAR(total_area(roofs), 12.6 * 9.8 / std::cos(0.5), kFaceTol_m);
  // 1 m of foundation; the gables are triangles of 9 m over 4.5 m tan(0.5)
  EXPECT_NEAR(total_area(walls), 2.0 * (12.0 + 9.0) * 6.0 + 9.0 * 4.5 * std::tan(0.5), kFaceTol_m);
}

TEST(TrueFaces, ARimHasWallsOnBothSidesAndTheDeckNone) {
  HouseShape shape;
  shape.building_id = 0;
  const std::vector<Face> faces = faces_of(parapet(shape, 0.3, 0.5));
  EXPECT_EQ(of_surface(faces, FaceKind::kRoof).size(), 5U);
  const auto walls = of_surface(faces, FaceKind::kWall);
  EXPECT_EQ(walls.size(), 8U);
  EXPECT_NEAR(total_area(walls), 2.0 * (12.0 + 9.0) * 6.5 + 2.0 * (11.4 + 8.4) * 0.5, kFaceTol_m);
  const auto grounds = of_surface(faces, FaceKind::kGround);
  EXPECT_EQ(grounds.size(), 1U);
  EXPECT_NEAR(total_area(grounds), 12.0 * 9.0, kFaceTol_m);
}

TEST(TrueFaces, ARimThatIsTurnedHasNoMoreWalls) {
  std::vector<RoofPart> parts = parapet(HouseShape{}, 0.3, 0.5);
  for (RoofPart& part : parts) part = placed(part, {31.7, 12.3}, 0.7);
  EXPECT_EQ(of_surface(faces_of(parts), FaceKind::kWall).size(), 8U);
}

TEST(TrueFaces, HousesOfARowHaveAllFourWalls) {
  VillageOptions options;
  options.roof_types = {RoofType::kRow};
  const SyntheticScene scene = make_village(options);
  std::vector<int> num_walls(scene.buildings.size(), 0);
  for (const Face& face : of_surface(scene.faces, FaceKind::kWall)) {
    ++num_walls[face.building];
  }
  EXPECT_THAT(num_walls, testing::Each(4));
  EXPECT_FALSE(num_walls.empty());
}

TEST(TrueFaces, ADormerIsCutWhereItEntersTheRoof) {
  HouseShape shape;
  shape.pitch_rad = 0.8;
  std::vector<RoofPart> parts = gabled(shape);
  const double bare = total_area(of_surface(faces_of(parts), FaceKind::kWall));
  parts.push_back(dormer(shape, Dormer{}));
  const std::vector<Face> faces = faces_of(parts);
  const auto roofs = of_surface(faces, FaceKind::kRoof);
  EXPECT_EQ(roofs.size(), 4U);
  // two triangles at its sides, and its front with the gable
  const auto walls = of_surface(faces, FaceKind::kWall);
  EXPECT_THAT(corner_counts(walls), ElementsAre(3U, 3U, 4U, 4U, 5U, 5U, 5U));
  const double height = 1.2;  // above the roof at the front
  const double front = 2.0 * height + 1.0 * std::tan(0.5);
  const double side = 0.5 * height * height / std::tan(0.8);
  EXPECT_NEAR(total_area(walls) - bare, front + 2.0 * side, kFaceTol_m);
  EXPECT_EQ(of_surface(faces, FaceKind::kGround).size(), 1U);
}

TEST(TrueFaces, ChimneysAreLeftOut) {
  HouseShape shape;
  std::vector<RoofPart> parts = gabled(shape);
  const std::size_t bare = faces_of(parts).size();
  parts.push_back(chimney(shape, 1.0, -1.2, 0.5));
  EXPECT_EQ(faces_of(parts).size(), bare);
}

TEST(TrueFaces, RoofsAreTheHighestSurfaceOfABuildingAndCoverItOnce) {
  const SyntheticScene scene = village_of_all_types(5);
  test::Random rng(7);
  std::size_t num_inside = 0;
  for (const SceneBuilding& building : scene.buildings) {
    const Eigen::Vector2d middle = building.footprint[0][0];
    for (int i = 0; i < 400; ++i) {
      const Eigen::Vector2d x =
          middle + Eigen::Vector2d(rng.uniform(-14.0, 14.0), rng.uniform(-14.0, 14.0));
      double top = -std::numeric_limits<double>::infinity();
      for (const ScenePlane& plane : scene.planes) {
        if (plane.building_id != building.id || plane.kind != PlaneKind::kRoof) continue;
        ConvexPolygon outline;
        for (const Eigen::Vector3d& corner : plane.outline) outline.push_back(corner.head<2>());
        const Eigen::Vector3d n = plane.plane.normal();
        if (contains(outline, x))
          top = std::max(top, -(n.x() * x.x() + n.y() * x.y() + plane.plane.offset()) / n.z());
      }
      std::vector<double> heights;
      for (const Face& face : scene.faces) {
        if (face.building == static_cast<std::size_t>(building.id) &&
            face.kind == FaceKind::kRoof && covers(face, x))
          heights.push_back(height_at(face, x));
      }
      if (std::isinf(top)) {
        EXPECT_TRUE(heights.empty()) << building.id;
        continue;
      }
      ++num_inside;
      ASSERT_EQ(heights.size(), 1U) << building.id << " at " << x.transpose();
      EXPECT_NEAR(heights[0], top, kFaceTol_m);
    }
  }
  EXPECT_GT(num_inside, 1000U);
}

TEST(TrueFaces, TrueLinesAreBordersOfAsManyRoofsAsTheyHavePlanes) {
  for (const std::uint64_t seed : {5U, 6U}) {
    const SyntheticScene scene = village_of_all_types(seed);
    std::size_t num_lines = 0;
    for (const SceneLine& line : scene.lines) {
      if (line.building_id == kNone) continue;
      ++num_lines;
      for (const double t : {0.01, 0.5, 0.99}) {
        const Eigen::Vector3d x = (1.0 - t) * line.segment.start + t * line.segment.end;
        const auto num_faces = std::ranges::count_if(scene.faces, [&](const Face& face) {
          return face.kind == FaceKind::kRoof && distance_to_border(face, x) < kFaceTol_m;
        });
        EXPECT_GE(num_faces, static_cast<std::ptrdiff_t>(line.plane_ids.size()))
            << name(line.kind) << " of " << line.building_id;
      }
    }
    EXPECT_GT(num_lines, 100U);
  }
}

TEST(TrueFaces, FacesAreFlatAndLookOutwards) {
  const SyntheticScene scene = village_of_all_types(5);
  for (const Face& face : scene.faces) {
    const Eigen::Vector3d normal = area_vector(face.rings[0]).normalized();
    for (const Corners& ring : face.rings) {
      ASSERT_GE(ring.size(), 3U);
      for (const Eigen::Vector3d& x : ring)
        EXPECT_NEAR(normal.dot(x - face.rings[0][0]), 0.0, kFaceTol_m);
    }
    if (face.kind == FaceKind::kRoof) {
      EXPECT_GT(normal.z(), 0.5);
    }
    if (face.kind == FaceKind::kGround) {
      EXPECT_LT(normal.z(), -0.999);
    }
    if (face.kind == FaceKind::kWall) {
      EXPECT_NEAR(normal.z(), 0.0, kFaceTol_m);
    }
  }
  EXPECT_TRUE(std::ranges::is_sorted(scene.faces, {}, &Face::building));
}

TEST(TrueModel, IsTheSceneOnTheMap) {
  const SyntheticScene scene = village_of_all_types(5);
  const io::BuildingModel model = true_model(scene);
  ASSERT_EQ(model.buildings.size(), scene.buildings.size());
  ASSERT_EQ(model.faces.size(), scene.faces.size());
  EXPECT_EQ(model.buildings[2].id, "building_2");
  EXPECT_EQ(model.crs.definition, scene.crs.definition);
  EXPECT_EQ(model.faces.back().building, scene.buildings.size() - 1);
  EXPECT_EQ(model.faces[0].rings[0][0], scene.frame.world_from_local(scene.faces[0].rings[0][0]));
  EXPECT_EQ(std::get<std::string>(model.attributes.rows[2][1].second),
            name(scene.buildings[2].type));
}

}  // namespace
}  // namespace ridgeline::simulate
