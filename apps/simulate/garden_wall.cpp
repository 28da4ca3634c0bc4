// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/garden_wall.h"

#include "apps/simulate/lot.h"
#include "apps/simulate/mesh_builder.h"

#include <utility>
#include <vector>

namespace ridgeline::simulate {
namespace {

std::vector<Eigen::Vector3d> on(const PlanFunction& height, const ConvexPolygon& outline) {
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector2d& x : outline) corners.emplace_back(x.x(), x.y(), height(x));
  return corners;
}

/// Adds the top and the sides of a wall, and the plane of its top.
void add_wall_body(const ConvexPolygon& outline,
                   const PlanFunction& ground,
                   const PlanFunction& top,
                   SyntheticScene& scene) {
  constexpr double kBelowGroundM = 0.5;
  const int plane_id = static_cast<int>(scene.planes.size());
  const int object_id = next_object_id(scene.mesh);
  const std::vector<Eigen::Vector3d> upper = on(top, outline);
  const std::vector<Eigen::Vector3d> lower = on(ground, outline);
  const Eigen::Vector3d down(0.0, 0.0, -kBelowGroundM);
  add_polygon(upper, {kNone, plane_id, Material::kGardenWall, object_id}, scene.mesh);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    add_polygon({lower[i] + down, lower[j] + down, upper[j], upper[i]},
                {kNone, kNone, Material::kGardenWall, object_id}, scene.mesh);
  }
  scene.planes.push_back({.id = plane_id,
                          .plane = plane_of(top),
                          .outline = upper,
                          .building_id = kNone,
                          .kind = PlaneKind::kWallTop});
}

}  // namespace

void add_garden_wall(const Terrain& terrain,
                     const TerrainRow& row,
                     const Eigen::Vector2d& low_uv,
                     bool with_feet,
                     Random& random,
                     SyntheticScene& scene) {
  constexpr double kHalfWidthM = 0.15;
  const double length_m = random.uniform(5.0, 15.0);
  const double begin_v = low_uv.y() + random.uniform(0.0, kLotSizeM - length_m);
  const double height_m = random.uniform(0.8, 1.8);
  ConvexPolygon outline = rectangle({low_uv.x() - kHalfWidthM, begin_v},
                                    {low_uv.x() + kHalfWidthM, begin_v + length_m});
  for (Eigen::Vector2d& x : outline) {
    x = terrain.local(x);
    if ((x.array() < 0.0).any() || (x.array() > scene.extent_m.array()).any()) return;
  }
  PlanFunction top = row.ground;
  top.offset += height_m;
  add_wall_body(outline, row.ground, top, scene);
  const auto add_lines = [&](const PlanFunction& surface, LineKind kind, int plane_id) {
    const std::vector<Eigen::Vector3d> corners = on(surface, outline);
    for (const std::size_t i : {1U, 3U}) {  // the long sides of the rectangle
      scene.lines.push_back({.segment = {corners[i], corners[(i + 1) % 4]},
                             .kind = kind,
                             .plane_ids = {plane_id},
                             .building_id = kNone});
    }
  };
  add_lines(top, LineKind::kWallTop, scene.planes.back().id);
  if (with_feet) add_lines(row.ground, LineKind::kFoot, row.plane_id);
}

}  // namespace ridgeline::simulate
