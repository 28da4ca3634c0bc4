// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/als.h"
#include "apps/simulate/ray_scene.h"
#include "apps/simulate/village.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace ridgeline::simulate {
namespace {

SyntheticScene cluttered_village(std::uint64_t seed) {
  VillageOptions options;
  options.seed = seed;
  options.terrace_step_m = 1.0;
  set_clutter(options);
  return make_village(options);
}

std::vector<SceneLine> lines_of(const SyntheticScene& scene, LineKind kind) {
  std::vector<SceneLine> lines;
  std::copy_if(scene.lines.begin(), scene.lines.end(), std::back_inserter(lines),
               [&](const SceneLine& line) { return line.kind == kind; });
  return lines;
}

/// What a village was before it could have clutter.
struct Fingerprint {
  std::uint64_t seed;
  std::size_t vertices, planes, lines, points;
  double sum_of_mesh, sum_of_lines, sum_of_points;
};

constexpr Fingerprint kVillage5{.seed = 5,
                                .vertices = 92458,
                                .planes = 80,
                                .lines = 447,
                                .points = 14712,
                                .sum_of_mesh = 11560414.613342,
                                .sum_of_lines = 169874.677009,
                                .sum_of_points = 1781218.061515};
constexpr Fingerprint kVillage6{.seed = 6,
                                .vertices = 117277,
                                .planes = 51,
                                .lines = 342,
                                .points = 14796,
                                .sum_of_mesh = 13919408.218718,
                                .sum_of_lines = 123136.346946,
                                .sum_of_points = 1787269.374987};

TEST(Clutter, IsNotThereUnlessAskedFor) {
  constexpr double kSumTol_m = 1e-3;  // rounding of some 1e5 coordinates
  for (const Fingerprint& before : {kVillage5, kVillage6}) {
    VillageOptions options;
    options.seed = before.seed;
    options.terrace_step_m = 1.0;
    const SyntheticScene scene = make_village(options);
    double sum_of_mesh = 0.0, sum_of_lines = 0.0, sum_of_points = 0.0;
    for (const Eigen::Vector3d& x : scene.mesh.vertices) sum_of_mesh += x.sum();
    for (const SceneLine& line : scene.lines) {
      sum_of_lines += line.segment.start.sum() + 2.0 * line.segment.end.sum();
    }
    AlsOptions als;
    als.seed = before.seed;
    als.density_per_m2 = 1.0;
    const io::PointCloud cloud = scan_als(scene, als);
    for (const io::CloudPoint& p : cloud.points) sum_of_points += p.x + p.y + p.z;
    EXPECT_EQ(scene.mesh.vertices.size(), before.vertices);
    EXPECT_EQ(scene.planes.size(), before.planes);
    EXPECT_EQ(scene.lines.size(), before.lines);
    EXPECT_EQ(cloud.points.size(), before.points);
    EXPECT_NEAR(sum_of_mesh, before.sum_of_mesh, kSumTol_m);
    EXPECT_NEAR(sum_of_lines, before.sum_of_lines, kSumTol_m);
    EXPECT_NEAR(sum_of_points, before.sum_of_points, kSumTol_m);
  }
}

/// Where a horizontal ray, just above a surface beside a line, meets a wall.
bool is_foot_of_wall(const RayScene& rays, const Segment3& line, double t) {
  constexpr double kBeside_m = 0.02;
  constexpr double kAbove_m = 0.06;
  constexpr double kWallTol_m = 1e-4;
  constexpr double kSlope_m = 0.03;  // of a steep roof over kBeside_m
  const Eigen::Vector3d along = line.end - line.start;
  const Eigen::Vector3d across = Eigen::Vector3d(-along.y(), along.x(), 0.0).normalized();
  for (const double side : {-1.0, 1.0}) {
    Eigen::Vector3d from = point_at(line, t) + side * kBeside_m * across;
    from.z() += kAbove_m;
    const auto wall = rays.first_hit(from, -side * across);
    const auto below = rays.first_hit(from, -Eigen::Vector3d::UnitZ());
    if (wall && std::abs(wall->distance_m - kBeside_m) < kWallTol_m && below &&
        std::abs(below->distance_m - kAbove_m) < kSlope_m) {
      return true;
    }
  }
  return false;
}

TEST(Clutter, FeetAreWhereWallsOfTheMeshMeetASurface) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const SyntheticScene scene = cluttered_village(seed);
    const RayScene rays(scene.mesh);
    const std::vector<SceneLine> feet = lines_of(scene, LineKind::kFoot);
    ASSERT_GT(feet.size(), 80U);
    for (const SceneLine& foot : feet) {
      for (const double t : {0.25, 0.5, 0.75}) {
        EXPECT_TRUE(is_foot_of_wall(rays, foot.segment, t))
            << "seed " << seed << ", building " << foot.building_id << ", at "
            << point_at(foot.segment, t).transpose();
      }
    }
  }
}

/// Whether the sky is seen from just above a surface on either side of a line, in any direction.
bool is_outside(const RayScene& rays, const Segment3& line) {
  constexpr double kBeside_m = 0.02;
  constexpr int kAzimuths = 16;
  const Eigen::Vector3d along = line.end - line.start;
  const Eigen::Vector3d across = Eigen::Vector3d(-along.y(), along.x(), 0.0).normalized();
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d from = point_at(line, 0.5) + side * kBeside_m * across +
                                 3.0 * kBeside_m * Eigen::Vector3d::UnitZ();
    for (const double rise : {0.1, 0.5, 1.2}) {  // the lowest passes below eaves over an annex
      for (int i = 0; i < kAzimuths; ++i) {
        const double azimuth = 2.0 * std::numbers::pi * i / kAzimuths;
        const Eigen::Vector3d to_sky(std::cos(azimuth), std::sin(azimuth), rise);
        if (!rays.occluded(from, to_sky.normalized())) return true;
      }
    }
  }
  return false;
}

TEST(Clutter, NoFootIsWithinAHouse) {
  VillageOptions options;
  options.roof_types = {RoofType::kRow, RoofType::kLShaped, RoofType::kParapet};
  options.annex_share = 1.0;
  options.trees_per_lot = 0.0;
  options.with_feet = true;
  const SyntheticScene scene = make_village(options);
  const RayScene rays(scene.mesh);
  for (const SceneLine& foot : lines_of(scene, LineKind::kFoot)) {
    EXPECT_TRUE(is_outside(rays, foot.segment))
        << "building " << foot.building_id << ", at " << point_at(foot.segment, 0.5).transpose();
  }
}

TEST(Clutter, FeetLieOnGroundsAndOnLowerRoofs) {
  int on_ground = 0, on_roofs = 0;
  const SyntheticScene scene = cluttered_village(1);
  for (const SceneLine& foot : lines_of(scene, LineKind::kFoot)) {
    const PlaneKind kind = scene.planes[static_cast<std::size_t>(foot.plane_ids.at(0))].kind;
    ++(kind == PlaneKind::kGround ? on_ground : on_roofs);
  }
  EXPECT_GT(on_ground, 50);
  EXPECT_GT(on_roofs, 10);
}

TEST(Clutter, EdgesOfObjectsAndWallsLieOnTheMesh) {
  constexpr double kInside_m = 0.01;
  constexpr double kHeightTol_m = 1e-3;  // of a top that is inclined
  constexpr double kAbove_m = 0.5;
  const SyntheticScene scene = cluttered_village(2);
  const RayScene rays(scene.mesh);
  for (const LineKind kind : {LineKind::kObject, LineKind::kWallTop}) {
    const std::vector<SceneLine> lines = lines_of(scene, kind);
    ASSERT_GT(lines.size(), 10U) << name(kind);
    for (const SceneLine& line : lines) {
      const Eigen::Vector3d along = line.segment.end - line.segment.start;
      const Eigen::Vector3d across = Eigen::Vector3d(-along.y(), along.x(), 0.0).normalized();
      // outlines are counter-clockwise: the top is on the left
      const Eigen::Vector3d x = point_at(line.segment, 0.5) + kInside_m * across;
      const auto hit =
          rays.first_hit(x + kAbove_m * Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ());
      ASSERT_TRUE(hit) << name(kind);
      EXPECT_NEAR(hit->distance_m, kAbove_m, kHeightTol_m) << name(kind);
    }
  }
}

TEST(Clutter, AnObjectHasNoTrueDistance) {
  const SyntheticScene scene = cluttered_village(1);
  for (std::size_t i = 0; i < scene.lines.size(); ++i) {
    if (scene.lines[i].kind != LineKind::kObject) continue;
    EXPECT_THROW((void)true_mean_distance(scene, scene.lines[i].segment, static_cast<int>(i)),
                 std::invalid_argument);
    return;
  }
  FAIL() << "no object";
}

TEST(Clutter, HasLinesOfObjectsIfTheyAreAskedFor) {
  VillageOptions options;
  set_clutter(options);
  EXPECT_FALSE(lines_of(make_village(options), LineKind::kObject).empty());
  options.with_objects = false;
  EXPECT_TRUE(lines_of(make_village(options), LineKind::kObject).empty());
}

std::size_t parts_of_all(const SyntheticScene& scene) {
  std::size_t n = 0;
  for (const SceneBuilding& building : scene.buildings) n += building.footprint.size();
  return n;
}

TEST(Clutter, AnnexesAreLowerThanTheirHouses) {
  VillageOptions options;
  options.roof_types = {RoofType::kGabled, RoofType::kFlat};
  const std::size_t parts_before = parts_of_all(make_village(options));
  options.annex_share = 1.0;
  const SyntheticScene scene = make_village(options);
  EXPECT_GT(parts_of_all(scene), parts_before + scene.buildings.size() / 2);
  for (const SceneBuilding& building : scene.buildings) {
    double lowest_eave_m = 1e9, ridge_m = -1e9;
    for (const SceneLine& line : scene.lines) {
      if (line.building_id != building.id) continue;
      lowest_eave_m = std::min(lowest_eave_m, line.segment.start.z());
      ridge_m = std::max(ridge_m, line.segment.start.z());
    }
    EXPECT_LT(lowest_eave_m, ridge_m);
  }
}

TEST(Clutter, DormersHaveSmallFaces) {
  VillageOptions options;
  options.roof_types = {RoofType::kGabled};
  options.min_pitch_deg = 35.0;
  const std::size_t planes_before = make_village(options).planes.size();
  options.dormer_share = 1.0;
  const SyntheticScene scene = make_village(options);
  EXPECT_GT(scene.planes.size(), planes_before + scene.buildings.size());
  int small_faces = 0;
  for (const ScenePlane& plane : scene.planes) {
    ConvexPolygon outline;
    for (const Eigen::Vector3d& x : plane.outline) outline.emplace_back(x.head<2>());
    if (plane.kind == PlaneKind::kRoof && area(outline) < 10.0) ++small_faces;
  }
  EXPECT_GT(small_faces, static_cast<int>(scene.buildings.size()));
}

}  // namespace
}  // namespace ridgeline::simulate
