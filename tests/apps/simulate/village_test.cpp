// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/village.h"

#include "apps/simulate/random.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace ridgeline::simulate {
namespace {

constexpr double kVillageTol = 1e-9;  // the exactness that SyntheticScene promises

SyntheticScene village(std::uint64_t seed) {
  VillageOptions options;
  options.seed = seed;
  return make_village(options);
}

double end_distance(const SceneLine& line, const Plane3& plane) {
  return std::max(std::abs(plane.signedDistance(line.segment.start)),
                  std::abs(plane.signedDistance(line.segment.end)));
}

std::string printed(const SyntheticScene& scene) {
  std::ostringstream out;
  out.precision(17);
  for (const Eigen::Vector3d& x : scene.mesh.vertices) out << x.transpose() << '\n';
  for (const Triangle& t : scene.mesh.triangles) {
    out << t.vertices[0] << ' ' << t.plane_id << ' ' << static_cast<int>(t.material) << '\n';
  }
  for (const SceneLine& line : scene.lines) out << name(line.kind) << line.building_id << '\n';
  return out.str();
}

/// Distance from a point to the nearest line that bears all the planes.
double distance_to_line_of(const std::vector<const std::vector<SceneLine>*>& sets,
                           const Eigen::Vector3d& x,
                           const std::vector<int>& planes) {
  double best = 1e9;
  for (const std::vector<SceneLine>* lines : sets) {
    for (const SceneLine& line : *lines) {
      const bool bears_all = std::all_of(planes.begin(), planes.end(), [&](int plane) {
        return std::count(line.plane_ids.begin(), line.plane_ids.end(), plane) > 0;
      });
      if (bears_all) best = std::min(best, distance(line.segment, x));
    }
  }
  return best;
}

/// A seed, and whether with clutter.
class EachSeed : public testing::TestWithParam<std::pair<std::uint64_t, bool>> {
 protected:
  static SyntheticScene scene_of_seed() {
    VillageOptions options;
    options.seed = GetParam().first;
    if (GetParam().second) set_clutter(options);
    return make_village(options);
  }
};

std::size_t expected_planes(LineKind kind) {
  if (kind == LineKind::kObject) return 0;
  return kind == LineKind::kRidge || kind == LineKind::kHip || kind == LineKind::kValley ? 2 : 1;
}

TEST_P(EachSeed, TrueLinesLieOnTheirPlanes) {
  const SyntheticScene scene = scene_of_seed();
  ASSERT_GT(scene.lines.size(), 100U);
  for (const std::vector<SceneLine>* lines : {&scene.lines, &scene.joints}) {
    for (const SceneLine& line : *lines) {
      EXPECT_EQ(line.plane_ids.size(), expected_planes(line.kind)) << name(line.kind);
      for (const int id : line.plane_ids) {
        const ScenePlane& plane = scene.planes.at(static_cast<std::size_t>(id));
        EXPECT_LT(end_distance(line, plane.plane), kVillageTol) << name(line.kind);
      }
    }
  }
}

TEST_P(EachSeed, TrueLinesLieOnTheTopSurface) {
  const SyntheticScene scene = scene_of_seed();
  const test::TopSurface top(scene);
  for (const SceneLine& line : scene.lines) {
    if (line.kind == LineKind::kFoot) continue;  // eaves may hide it
    for (const double t : {0.01, 0.3, 0.7, 0.99}) {
      const Eigen::Vector3d x = point_at(line.segment, t);
      EXPECT_LT(top.at(x.head<2>()).x.z(), x.z() + 1e-6) << name(line.kind);
    }
  }
}

/// Along transects through each house: wherever the top surface changes from one plane to another,
/// a true line or a joint of the right planes must lie there. So no edge of a roof is missing.
TEST_P(EachSeed, TrueLinesAndJointsCloseEveryRoof) {
  constexpr double kStepM = 0.1;
  constexpr double kReachM = 12.0;
  constexpr int kSteps = 240;         // over twice the reach
  constexpr double kClosedM = 0.011;  // slivers up to 1 cm are no lines
  const SyntheticScene scene = scene_of_seed();
  const test::TopSurface top(scene);
  Random random({GetParam().first, 99});
  int changes = 0;
  for (const SceneBuilding& building : scene.buildings) {
    const Eigen::Vector2d centre = building.footprint.front().front();
    for (int transect = 0; transect < 4; ++transect) {
      const double phi = random.uniform(0.0, std::numbers::pi);
      const Eigen::Vector2d along(std::cos(phi), std::sin(phi));
      const auto at = [&](double s) { return top.at(centre + s * along); };
      for (int step = 0; step < kSteps; ++step) {
        double low = kStepM * step - kReachM;
        double high = low + kStepM;
        if (at(low).plane_id == at(high).plane_id) continue;
        while (high - low > 1e-10) {
          const double middle = 0.5 * (low + high);
          (at(middle).plane_id == at(low).plane_id ? low : high) = middle;
        }
        const test::SurfaceSample a = at(low);
        const test::SurfaceSample b = at(high);
        if (a.plane_id == kNone || b.plane_id == kNone) continue;
        const bool level = std::abs(a.x.z() - b.x.z()) < 1e-6;
        for (const test::SurfaceSample& side : {a, b}) {
          if (scene.planes[static_cast<std::size_t>(side.plane_id)].kind != PlaneKind::kRoof) {
            continue;
          }
          const double gap =
              distance_to_line_of({&scene.lines, &scene.joints}, side.x, {side.plane_id});
          EXPECT_LT(gap, kClosedM) << "building " << building.id << " at " << side.x.transpose()
                                   << (level ? " crease" : " step");
          ++changes;
        }
      }
    }
  }
  EXPECT_GT(changes, 100);
}

TEST_P(EachSeed, HousesKeepApartAndInside) {
  const SyntheticScene scene = scene_of_seed();
  ASSERT_GE(scene.buildings.size(), 8U);
  for (const SceneBuilding& a : scene.buildings) {
    for (const ConvexPolygon& outline : a.roof_footprint) {
      for (const Eigen::Vector2d& corner : outline) {
        EXPECT_TRUE((corner.array() >= 0.0).all() &&
                    (corner.array() <= scene.extent_m.array()).all());
      }
      for (const SceneBuilding& b : scene.buildings) {
        const bool row_counterparts =
            a.type == RoofType::kRow && b.type == RoofType::kRow && std::abs(a.id - b.id) <= 2;
        if (a.id == b.id || row_counterparts) continue;
        for (const ConvexPolygon& other : b.roof_footprint) EXPECT_FALSE(overlap(outline, other));
      }
    }
  }
}

TEST_P(EachSeed, OutlinesOfPlanesLieOnThem) {
  const SyntheticScene scene = scene_of_seed();
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    const ScenePlane& plane = scene.planes[i];
    EXPECT_EQ(plane.id, static_cast<int>(i));
    for (const Eigen::Vector3d& corner : plane.outline) {
      EXPECT_NEAR(plane.plane.signedDistance(corner), 0.0, kVillageTol);
    }
  }
  for (const Triangle& triangle : scene.mesh.triangles) {
    if (triangle.plane_id == kNone) continue;
    const ScenePlane& plane = scene.planes.at(static_cast<std::size_t>(triangle.plane_id));
    for (const std::int32_t vertex : triangle.vertices) {
      const Eigen::Vector3d& x = scene.mesh.vertices.at(static_cast<std::size_t>(vertex));
      EXPECT_NEAR(plane.plane.signedDistance(x), 0.0, kVillageTol);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Village,
                         EachSeed,
                         testing::Values(std::pair(1U, false),
                                         std::pair(2U, false),
                                         std::pair(3U, false),
                                         std::pair(4U, false),
                                         std::pair(1U, true),
                                         std::pair(2U, true),
                                         std::pair(3U, true),
                                         std::pair(4U, true)));

TEST(MakeVillage, EqualSeedsGiveEqualBytesAndOthersDoNot) {
  EXPECT_EQ(printed(village(5)), printed(village(5)));
  EXPECT_NE(printed(village(5)), printed(village(6)));
}

TEST(MakeVillage, BuildsEachRoofTypeOverTenSeeds) {
  std::set<RoofType> types;
  std::set<LineKind> kinds;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SyntheticScene scene = village(seed);
    for (const SceneBuilding& building : scene.buildings) types.insert(building.type);
    for (const SceneLine& line : scene.lines) kinds.insert(line.kind);
  }
  EXPECT_EQ(types.size(), static_cast<std::size_t>(kNumRoofTypes));
  EXPECT_EQ(kinds.size(), 6U);
}

TEST(MakeVillage, BuildsOnlyTheRoofTypesAskedFor) {
  VillageOptions options;
  options.roof_types = {RoofType::kHipped, RoofType::kShed};
  for (const SceneBuilding& building : make_village(options).buildings) {
    EXPECT_TRUE(building.type == RoofType::kHipped || building.type == RoofType::kShed);
  }
}

TEST(MakeVillage, DormersAndChimneysOfAHouseKeepApartBelowItsRidge) {
  VillageOptions options;
  options.roof_types = {RoofType::kGabledDormers, RoofType::kShedDormers};
  const SyntheticScene scene = make_village(options);
  for (const SceneBuilding& building : scene.buildings) {
    const std::vector<ConvexPolygon>& parts = building.roof_footprint;
    ASSERT_GE(parts.size(), 3U);  // house, a dormer, a chimney
    for (std::size_t i = 1; i < parts.size(); ++i) {
      for (std::size_t k = i + 1; k < parts.size(); ++k) EXPECT_FALSE(overlap(parts[i], parts[k]));
    }
    double ridge_z = -1e9;  // of the main body: the longest ridge
    double longest = 0.0;
    double highest = -1e9;
    for (const SceneLine& line : scene.lines) {
      if (line.building_id != building.id) continue;
      highest = std::max({highest, line.segment.start.z(), line.segment.end.z()});
      if (line.kind == LineKind::kRidge && length(line.segment) > longest) {
        longest = length(line.segment);
        ridge_z = line.segment.start.z();
      }
    }
    EXPECT_NEAR(highest, ridge_z, kVillageTol);
  }
}

TEST(MakeVillage, RowHousesShareNoVergeAndKeepTheirEaves) {
  VillageOptions options;
  options.roof_types = {RoofType::kRow};
  const SyntheticScene scene = make_village(options);
  std::map<std::pair<int, LineKind>, int> counts;
  for (const SceneLine& line : scene.lines) ++counts[{line.building_id, line.kind}];
  ASSERT_EQ(scene.buildings.size() % 3, 0U);
  for (std::size_t first = 0; first < scene.buildings.size(); first += 3) {
    int verges = 0;
    for (int id = scene.buildings[first].id; id < scene.buildings[first].id + 3; ++id) {
      EXPECT_EQ((counts[{id, LineKind::kRidge}]), 1);
      EXPECT_EQ((counts[{id, LineKind::kEave}]), 2);
      verges += counts[{id, LineKind::kVerge}];
    }
    EXPECT_EQ(verges, 8);  // two at each end and, of the higher house, at each party wall
  }
}

TEST(MakeVillage, GroundEndsWithTheExtent) {
  const SyntheticScene scene = village(1);
  const auto inside = [&](const Eigen::Vector3d& x) {
    return x.head<2>().minCoeff() > -kVillageTol &&
           (scene.extent_m - x.head<2>()).minCoeff() > -kVillageTol;
  };
  double ground_m2 = 0.0;
  for (const Triangle& triangle : scene.mesh.triangles) {
    ConvexPolygon corners;
    for (const std::int32_t vertex : triangle.vertices) {
      const Eigen::Vector3d& x = scene.mesh.vertices[static_cast<std::size_t>(vertex)];
      EXPECT_TRUE(inside(x)) << x.transpose();
      corners.emplace_back(x.head<2>());
    }
    const bool ground = triangle.material == Material::kGround ||
                        triangle.material == Material::kStreet ||
                        triangle.material == Material::kMarking;
    if (ground) ground_m2 += area(corners);
  }
  // no hole and no overlap: the tiles sum to the extent
  EXPECT_NEAR(ground_m2, scene.extent_m.prod(), 1e-6);
  for (const SceneLine& line : scene.lines) {
    EXPECT_TRUE(inside(line.segment.start) && inside(line.segment.end));
  }
}

TEST(MakeVillage, OriginShiftsTheWorldAndNothingElse) {
  VillageOptions options;
  options.origin_m = {1000.0, 2000.0, -5.0};
  const SyntheticScene moved = make_village(options);
  const SyntheticScene scene = make_village(VillageOptions{});
  EXPECT_EQ(printed(moved), printed(scene));
  const Eigen::Vector3d shift = options.origin_m - VillageOptions{}.origin_m;
  const io::LineSet a = true_lines(scene);
  const io::LineSet b = true_lines(moved);
  ASSERT_EQ(a.lines.size(), b.lines.size());
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    const Eigen::Vector3d gap =
        b.lines[i].segment_in_world.start - a.lines[i].segment_in_world.start - shift;
    EXPECT_LT(gap.norm(), 2e-9);  // two ulp of a northing of 5.4e6 m
  }
}

TEST(MakeVillage, AlignedShareRulesTheRidgesParallelToX) {
  for (const double share : {0.0, 1.0}) {
    VillageOptions options;
    options.aligned_share = share;
    for (const SceneBuilding& building : make_village(options).buildings) {
      EXPECT_EQ(std::abs(std::sin(building.ridge_azimuth_rad)) < 1e-12, share == 1.0);
    }
  }
}

TEST(MakeVillage, PitchesKeepToTheirRange) {
  VillageOptions options;
  options.min_pitch_deg = 20.0;
  options.max_pitch_deg = 30.0;
  options.roof_types = {RoofType::kGabled, RoofType::kHipped, RoofType::kLShaped, RoofType::kRow};
  for (const SceneBuilding& building : make_village(options).buildings) {
    EXPECT_GE(building.pitch_rad, 20.0 * std::numbers::pi / 180.0);
    EXPECT_LE(building.pitch_rad, 30.0 * std::numbers::pi / 180.0);
  }
}

TEST(MakeVillage, TerracesStepTheGroundFromRowToRow) {
  VillageOptions options;
  options.terrace_step_m = 2.0;
  options.terrain_slope_deg = 0.0;
  std::set<double> heights;
  for (const ScenePlane& plane : make_village(options).planes) {
    if (plane.kind == PlaneKind::kGround) heights.insert(plane.outline.front().z());
  }
  ASSERT_GE(heights.size(), 3U);
  EXPECT_NEAR(*std::next(heights.begin()) - *heights.begin(), 2.0, kVillageTol);
}

TEST(MakeVillage, RejectsOptionsOutsideTheirRange) {
  const auto rejects = [](auto change) {
    VillageOptions options;
    change(options);
    EXPECT_THROW(make_village(options), std::invalid_argument);
  };
  rejects([](VillageOptions& o) { o.extent_m.x() = 10.0; });
  rejects([](VillageOptions& o) { o.extent_m.y() = std::nan(""); });
  rejects([](VillageOptions& o) { o.origin_m.x() = 0.5; });
  rejects([](VillageOptions& o) { o.aligned_share = 1.1; });
  rejects([](VillageOptions& o) { o.built_share = -0.1; });
  rejects([](VillageOptions& o) { o.fence_share = 1.5; });
  rejects([](VillageOptions& o) { o.terrain_slope_deg = 16.0; });
  rejects([](VillageOptions& o) { o.terrace_step_m = -1.0; });
  rejects([](VillageOptions& o) { o.min_pitch_deg = 9.0; });
  rejects([](VillageOptions& o) { o.max_pitch_deg = 10.0; });
  rejects([](VillageOptions& o) { o.trees_per_lot = 7.0; });
  rejects([](VillageOptions& o) { o.annex_share = 1.5; });
  rejects([](VillageOptions& o) { o.dormer_share = -0.5; });
  rejects([](VillageOptions& o) { o.garden_wall_share = 2.0; });
  rejects([](VillageOptions& o) { o.cars_per_lot = 5.0; });
}

TEST(TrueLines, CarryKindBuildingPlanesAndWorldCoordinates) {
  const SyntheticScene scene = village(1);
  const io::LineSet set = true_lines(scene);
  ASSERT_EQ(set.lines.size(), scene.lines.size());
  EXPECT_EQ(set.crs.definition, "EPSG:25832");
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    const io::Line& line = set.lines[i];
    EXPECT_EQ(line.id, std::to_string(i));
    EXPECT_EQ(line.kind, name(scene.lines[i].kind));
    EXPECT_EQ(line.building.empty(), scene.lines[i].building_id == kNone);
    EXPECT_EQ(line.plane_ids, scene.lines[i].plane_ids);
    const Eigen::Vector3d local = scene.frame.local_from_world(line.segment_in_world.end);
    EXPECT_LT((local - scene.lines[i].segment.end).norm(), 2e-9);
  }
}

}  // namespace
}  // namespace ridgeline::simulate
