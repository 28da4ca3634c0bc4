// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/mesh_builder.h"

namespace ridgeline::simulate {

void add_polygon(const std::vector<Eigen::Vector3d>& corners,
                 const SurfaceAppearance& look,
                 Mesh& mesh) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  const auto n = static_cast<std::int32_t>(corners.size());
  if (n < 3) return;
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  for (std::int32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({.vertices = {first, first + i, first + i + 1},
                              .building_id = look.building_id,
                              .plane_id = look.plane_id,
                              .material = look.material,
                              .object_id = look.object_id});
  }
}

void add_prism(const ConvexPolygon& outline,
               double low_z,
               double high_z,
               const SurfaceAppearance& look,
               Mesh& mesh) {
  std::vector<Eigen::Vector3d> top;
  for (const Eigen::Vector2d& x : outline) top.emplace_back(x.x(), x.y(), high_z);
  add_polygon(top, look, mesh);
  const Eigen::Vector3d down(0.0, 0.0, low_z - high_z);
  for (std::size_t i = 0; i < top.size(); ++i) {
    const Eigen::Vector3d& a = top[i];
    const Eigen::Vector3d& b = top[(i + 1) % top.size()];
    add_polygon({a + down, b + down, b, a}, look, mesh);
  }
}

}  // namespace ridgeline::simulate
