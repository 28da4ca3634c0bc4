// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/roof_part.h"

#include "apps/simulate/mesh_builder.h"
#include "apps/simulate/roof_lines.h"
#include "apps/simulate/true_faces.h"

#include <algorithm>
#include <iterator>

namespace ridgeline::simulate {
namespace {

Eigen::Vector3d lift(const Eigen::Vector2d& x, double z) { return {x.x(), x.y(), z}; }

void add_plane(const RoofPart& part, const PartFace& face, SyntheticScene& scene) {
  ScenePlane plane{.id = face.plane_id,
                   .plane = plane_of(face.height),
                   .outline = {},
                   .building_id = part.building_id,
                   .kind = part.kind};
  for (const Eigen::Vector2d& corner : face.cell.corners) {
    plane.outline.push_back(lift(corner, face.height(corner)));
  }
  scene.planes.push_back(std::move(plane));
}

/// Adds the top, the underside and the fascia of one face.
void add_slab(const RoofPart& part, const PartFace& face, Mesh& mesh) {
  const ConvexPolygon& corners = face.cell.corners;
  const bool chimney = part.kind == PlaneKind::kChimney;
  const SurfaceAppearance top{part.building_id, face.plane_id,
                              chimney ? Material::kChimney : Material::kRoof};
  std::vector<Eigen::Vector3d> upper;
  for (const Eigen::Vector2d& x : corners) upper.push_back(lift(x, face.height(x)));
  add_polygon(upper, top, mesh);
  if (part.slab_thickness_m <= 0.0) return;

  std::vector<Eigen::Vector3d> lower(upper.rbegin(), upper.rend());
  for (Eigen::Vector3d& x : lower) x.z() -= part.slab_thickness_m;
  add_polygon(lower, {part.building_id, kNone, Material::kWall}, mesh);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (face.cell.labels[i] < 0) continue;
    const Eigen::Vector3d& a = upper[i];
    const Eigen::Vector3d& b = upper[(i + 1) % upper.size()];
    const Eigen::Vector3d down(0.0, 0.0, -part.slab_thickness_m);
    add_polygon({{a + down, b + down, b, a}}, {part.building_id, kNone, Material::kGutter}, mesh);
  }
}

/// Adds the piece of each wall below one face, up to the underside of the roof.
void add_walls(const RoofPart& part, const PartFace& face, Mesh& mesh) {
  const bool chimney = part.kind == PlaneKind::kChimney;
  const SurfaceAppearance look{part.building_id, kNone,
                               chimney ? Material::kChimney : Material::kWall};
  const std::vector<PlanFunction> cell = half_planes(face.cell.corners);
  for (std::size_t i = 0; i < part.walls.size(); ++i) {
    const Segment2 wall{part.walls[i], part.walls[(i + 1) % part.walls.size()]};
    PlanInterval interval;
    // walls below a roof without overhang lie exactly on the border of the cell and must not be
    // lost by rounding
    constexpr double kBorderM = 1e-9;
    for (const PlanFunction& side : cell) {
      interval = clip(interval, wall, {side.gradient, side.offset + kBorderM});
    }
    if (interval.empty()) continue;
    const Eigen::Vector2d a = wall.start + interval.begin * (wall.end - wall.start);
    const Eigen::Vector2d b = wall.start + interval.end * (wall.end - wall.start);
    const double za = face.height(a) - part.slab_thickness_m;
    const double zb = face.height(b) - part.slab_thickness_m;
    add_polygon({{lift(a, part.base_z_m), lift(b, part.base_z_m), lift(b, zb), lift(a, za)}}, look,
                mesh);
  }
}

}  // namespace

std::vector<PartFace> roof_faces(std::span<const RoofPart> parts, int first_plane_id) {
  std::vector<PartFace> faces;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const RoofPart& part = parts[p];
    LabelledPolygon outline{part.outline, {}};
    for (std::size_t i = 0; i < part.outline.size(); ++i) {
      outline.labels.push_back(static_cast<int>(i));
    }
    for (std::size_t k = 0; k < part.tops.size(); ++k) {
      LabelledPolygon cell = outline;
      for (std::size_t j = 0; j < part.tops.size(); ++j) {
        if (j != k) cell = clip(cell, part.tops[j] - part.tops[k], -1 - static_cast<int>(j));
      }
      if (cell.corners.empty()) continue;
      const int id = first_plane_id + static_cast<int>(faces.size());
      faces.push_back(
          {static_cast<int>(p), id, part.tops[k], std::move(cell), static_cast<int>(k)});
    }
  }
  return faces;
}

void add_structure(std::span<const RoofPart> parts, SyntheticScene& scene) {
  const std::vector<PartFace> faces = roof_faces(parts, static_cast<int>(scene.planes.size()));
  for (const PartFace& face : faces) {
    const RoofPart& part = parts[static_cast<std::size_t>(face.part)];
    add_plane(part, face, scene);
    add_slab(part, face, scene.mesh);
    add_walls(part, face, scene.mesh);
  }
  std::ranges::move(true_faces(parts, faces), std::back_inserter(scene.faces));
  for (SceneLine& line : roof_lines(parts, faces)) {
    (line.kind == LineKind::kJoint ? scene.joints : scene.lines).push_back(std::move(line));
  }
}

}  // namespace ridgeline::simulate
