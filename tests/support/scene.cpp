// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/scene.h"

#include "apps/simulate/houses.h"
#include "apps/simulate/terrain.h"

#include <algorithm>
#include <numbers>

namespace ridgeline::test {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

simulate::HouseShape shape_with(double pitch_deg) {
  return {.length_m = HouseScene::kLengthM,
          .width_m = HouseScene::kWidthM,
          .pitch_rad = kRadPerDeg * pitch_deg,
          .eave_overhang_m = HouseScene::kEaveOverhangM,
          .verge_overhang_m = HouseScene::kVergeOverhangM,
          .wall_height_m = HouseScene::kWallHeightM};
}

simulate::SyntheticScene scene_of(std::vector<simulate::RoofPart> parts,
                                  simulate::RoofType type,
                                  double azimuth_deg) {
  constexpr double kHalfM = 20.0;
  simulate::SyntheticScene scene;
  scene.extent_m = {2.0 * kHalfM, 2.0 * kHalfM};
  simulate::Terrain terrain(0.0, scene);
  const simulate::TerrainRow ground = terrain.add_row(0.0, kHalfM, {});
  terrain.add_tile(ground, {-kHalfM, -kHalfM}, {kHalfM, kHalfM}, simulate::Material::kGround);

  simulate::SceneBuilding building;
  building.type = type;
  building.ridge_azimuth_rad = kRadPerDeg * azimuth_deg;
  for (simulate::RoofPart& part : parts) {
    part = placed(part, {kHalfM, kHalfM}, kRadPerDeg * azimuth_deg);
    building.footprint.push_back(part.walls);
    building.roof_footprint.push_back(part.outline);
  }
  scene.buildings.push_back(building);
  add_structure(parts, scene);
  return scene;
}

}  // namespace

simulate::SyntheticScene gabled_house(double pitch_deg, double azimuth_deg) {
  return scene_of(simulate::gabled(shape_with(pitch_deg)), simulate::RoofType::kGabled,
                  azimuth_deg);
}

simulate::SyntheticScene hipped_house(double pitch_deg, double azimuth_deg) {
  return scene_of(simulate::hipped(shape_with(pitch_deg)), simulate::RoofType::kHipped,
                  azimuth_deg);
}

simulate::SyntheticScene flat_house(double azimuth_deg) {
  return scene_of(simulate::flat(shape_with(0.0)), simulate::RoofType::kFlat, azimuth_deg);
}

TopSurface::TopSurface(const simulate::SyntheticScene& scene) {
  for (const simulate::ScenePlane& plane : scene.planes) {
    simulate::ConvexPolygon outline;
    for (const Eigen::Vector3d& corner : plane.outline) outline.emplace_back(corner.head<2>());
    faces_.push_back({plane.id, plane.plane, simulate::half_planes(outline)});
  }
}

SurfaceSample TopSurface::at(const Eigen::Vector2d& x) const {
  SurfaceSample top{{x.x(), x.y(), -1e9}, simulate::kNone};
  for (const Face& face : faces_) {
    const double z = height_at(face.plane, x);
    if (z <= top.x.z()) continue;
    const bool inside = std::all_of(face.sides.begin(), face.sides.end(),
                                    [&](const auto& side) { return side(x) >= 0.0; });
    if (inside) top = {{x.x(), x.y(), z}, face.plane_id};
  }
  return top;
}

std::vector<SurfaceSample> sample_grid(const simulate::SyntheticScene& scene, double spacing_m) {
  const TopSurface surface(scene);
  std::vector<SurfaceSample> samples;
  const Eigen::Vector2i count = (scene.extent_m / spacing_m).array().round().cast<int>();
  for (int row = 0; row < count.y(); ++row) {
    for (int column = 0; column < count.x(); ++column) {
      const SurfaceSample sample =
          surface.at({(column + 0.5) * spacing_m, (row + 0.5) * spacing_m});
      if (sample.plane_id != simulate::kNone) samples.push_back(sample);
    }
  }
  return samples;
}

io::PointCloud cloud_of(const simulate::SyntheticScene& scene,
                        const std::vector<SurfaceSample>& samples) {
  io::PointCloud cloud;
  cloud.frame = scene.frame;
  cloud.crs = scene.crs;
  for (const SurfaceSample& sample : samples) {
    const bool ground = scene.planes[static_cast<std::size_t>(sample.plane_id)].kind ==
                        simulate::PlaneKind::kGround;
    cloud.points.push_back({.x = sample.x.x(),
                            .y = sample.x.y(),
                            .z = sample.x.z(),
                            .intensity = 0,
                            .classification = static_cast<std::uint8_t>(ground ? 2 : 6),
                            .return_number = 1,
                            .number_of_returns = 1,
                            .flags = 0,
                            .source_id = 1});
  }
  cloud.n_read = cloud.points.size();
  return cloud;
}

}  // namespace ridgeline::test
