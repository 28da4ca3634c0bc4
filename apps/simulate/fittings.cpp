// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/fittings.h"

#include "apps/simulate/mesh_builder.h"
#include "apps/simulate/random.h"
#include "apps/simulate/ray_scene.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace ridgeline::simulate {
namespace {

constexpr std::uint64_t kFittingsStream = 0x66697474696e67;

/// A rectangle on an inclined plane: `u` horizontal, `v` up the slope, both unit vectors.
struct Panel {
  Eigen::Vector3d centre, u, v;
  double half_u_m, half_v_m;

  [[nodiscard]] Eigen::Vector3d normal() const { return u.cross(v); }
  [[nodiscard]] Eigen::Vector3d at(double s, double t) const {
    return centre + s * half_u_m * u + t * half_v_m * v;
  }
};

/// Adds a panel raised by `height_m` above its plane, including its narrow sides.
void add_panel(const Panel& panel, double height_m, const SurfaceAppearance& look, Mesh& mesh) {
  const Eigen::Vector3d up = height_m * panel.normal();
  const std::array<Eigen::Vector3d, 4> foot{panel.at(-1, -1), panel.at(1, -1), panel.at(1, 1),
                                            panel.at(-1, 1)};
  add_polygon({foot[0] + up, foot[1] + up, foot[2] + up, foot[3] + up}, look, mesh);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d& a = foot[i];
    const Eigen::Vector3d& b = foot[(i + 1) % 4];
    add_polygon({a, b, b + up, a + up}, look, mesh);
  }
}

Panel shrunk(Panel panel, double by_m) {
  panel.half_u_m -= by_m;
  panel.half_v_m -= by_m;
  return panel;
}

/// Adds a pane with its frame.
void add_window(const Panel& panel, const SurfaceAppearance& frame, Mesh& mesh) {
  constexpr double kFrameM = 0.09;
  constexpr double kFrameHeightM = 0.05;
  constexpr double kPaneHeightM = 0.06;
  SurfaceAppearance pane = frame;
  pane.material = Material::kGlass;
  add_panel(panel, kFrameHeightM, frame, mesh);
  add_panel(shrunk(panel, kFrameM), kPaneHeightM, pane, mesh);
}

/// One wall of a building: all convex pieces in one vertical plane.
struct Wall {
  Eigen::Vector3d u;                  ///< horizontal, to the right seen from outside
  Eigen::Vector3d outside;            ///< unit normal
  double distance_m = 0.0;            ///< distance of the plane from the origin along `outside`
  std::vector<ConvexPolygon> pieces;  ///< (along u, z)
};

/// The walls of all buildings, keyed by building, direction and distance.
std::map<std::tuple<int, int, int, int>, Wall> walls_of(const SyntheticScene& scene) {
  constexpr double kDirectionStep = 1e-3;
  constexpr double kDistanceStepM = 1e-2;
  std::map<std::tuple<int, int, int, int>, Wall> walls;
  const auto rounded = [](double x, double step) {
    return static_cast<int>(std::lround(x / step));
  };
  for (std::size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    const Triangle& triangle = scene.mesh.triangles[i];
    if (triangle.material != Material::kWall || triangle.building_id == kNone) continue;
    const Eigen::Vector3d n = triangle_normal(scene.mesh, static_cast<int>(i));
    if (!(std::abs(n.z()) < kDirectionStep)) continue;  // underside of a roof, or without area
    const auto corner = [&](std::size_t k) -> const Eigen::Vector3d& {
      return scene.mesh.vertices[static_cast<std::size_t>(triangle.vertices[k])];
    };
    const double distance_m = n.dot(corner(0));
    Wall& wall = walls[{triangle.building_id, rounded(n.x(), kDirectionStep),
                        rounded(n.y(), kDirectionStep), rounded(distance_m, kDistanceStepM)}];
    wall.outside = n;
    wall.u = Eigen::Vector3d::UnitZ().cross(n);
    wall.distance_m = distance_m;
    ConvexPolygon piece;
    for (std::size_t k = 0; k < 3; ++k) piece.emplace_back(wall.u.dot(corner(k)), corner(k).z());
    wall.pieces.push_back(std::move(piece));
  }
  return walls;
}

bool on_wall(const Wall& wall, const Eigen::Vector2d& x) {
  return std::any_of(wall.pieces.begin(), wall.pieces.end(),
                     [&](const ConvexPolygon& piece) { return contains(piece, x); });
}

/// Adds rows and columns of identical windows, as many as fit on the wall.
void add_windows(const Wall& wall, int building_id, Random& random, Mesh& mesh) {
  constexpr double kStoreyM = 2.8;
  constexpr double kSillM = 1.9;  // above the lowest corner, which is 1 m below the floor
  constexpr double kFreeM = 0.35;
  Eigen::AlignedBox2d box;
  for (const ConvexPolygon& piece : wall.pieces) {
    for (const Eigen::Vector2d& x : piece) box.extend(x);
  }
  const double half_u_m = random.uniform(0.4, 0.65);
  const double half_v_m = random.uniform(0.55, 0.75);
  const int columns = static_cast<int>(box.sizes().x() / random.uniform(2.0, 2.8));
  const SurfaceAppearance frame{building_id, kNone, Material::kFrame};
  for (int column = 0; column < columns; ++column) {
    const double along = box.min().x() + (column + 0.5) / columns * box.sizes().x();
    double next_m = box.min().y() + kSillM;
    while (next_m < box.max().y()) {
      const double low = next_m;
      next_m += kStoreyM;
      const Eigen::Vector2d reach(half_u_m + kFreeM, half_v_m + kFreeM);
      const Eigen::Vector2d middle(along, low + half_v_m);
      const bool fits = on_wall(wall, middle - reach) && on_wall(wall, middle + reach) &&
                        on_wall(wall, middle + Eigen::Vector2d(reach.x(), -reach.y())) &&
                        on_wall(wall, middle + Eigen::Vector2d(-reach.x(), reach.y()));
      if (!fits) continue;
      const Eigen::Vector3d centre = wall.distance_m * wall.outside + middle.x() * wall.u +
                                     middle.y() * Eigen::Vector3d::UnitZ();
      add_window({centre, wall.u, Eigen::Vector3d::UnitZ(), half_u_m, half_v_m}, frame, mesh);
    }
  }
}

/// Whether a panel and some free space around it lie on one surface of the scene and are not
/// covered.
bool is_free(const RayScene& rays, const SyntheticScene& scene, const Panel& panel, int plane_id) {
  constexpr double kFreeM = 0.35;
  constexpr double kAboveM = 30.0;
  const Panel wide = shrunk(panel, -kFreeM);
  for (const double s : {-1.0, -0.33, 0.33, 1.0}) {
    for (const double t : {-1.0, 0.0, 1.0}) {
      const Eigen::Vector3d from = wide.at(s, t) + kAboveM * Eigen::Vector3d::UnitZ();
      const auto hit = rays.first_hit(from, -Eigen::Vector3d::UnitZ());
      if (!hit) return false;
      const Triangle& triangle = scene.mesh.triangles[static_cast<std::size_t>(hit->triangle)];
      const bool bare =
          triangle.material == Material::kRoof || triangle.material == Material::kGround;
      if (triangle.plane_id != plane_id || !bare) return false;
    }
  }
  return true;
}

/// A panel at a random position on a plane, with horizontal sides and sides along the slope.
Panel random_panel(const ScenePlane& plane, double half_u_m, double half_v_m, Random& random) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& x : plane.outline) box.extend(x.head<2>());
  const Eigen::Vector2d at{random.uniform(box.min().x(), box.max().x()),
                           random.uniform(box.min().y(), box.max().y())};
  const Eigen::Vector3d n = plane.plane.normal();
  const Eigen::Vector3d u = Eigen::Vector3d::UnitZ().cross(n).normalized();
  return {{at.x(), at.y(), height_at(plane.plane, at)}, u, n.cross(u), half_u_m, half_v_m};
}

void add_skylights(const ScenePlane& plane,
                   const RayScene& rays,
                   Random& random,
                   SyntheticScene& scene) {
  constexpr int kAttempts = 12;
  const double half_u_m = random.uniform(0.35, 0.55);
  const double half_v_m = random.uniform(0.5, 0.7);
  const int wanted = random.integer(0, 3);
  std::vector<Panel> placed_panels;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Panel panel = random_panel(plane, half_u_m, half_v_m, random);
    const bool apart =
        std::all_of(placed_panels.begin(), placed_panels.end(),
                    [&](const Panel& other) { return (other.centre - panel.centre).norm() > 2.0; });
    if (static_cast<int>(placed_panels.size()) == wanted || !apart) continue;
    if (!is_free(rays, scene, panel, plane.id)) continue;
    add_window(panel, {plane.building_id, kNone, Material::kSolar}, scene.mesh);
    placed_panels.push_back(panel);
  }
}

/// Adds modules of 1.0 m x 1.65 m side by side in one or two rows. Returns whether a free place was
/// found.
bool add_solar_array(const ScenePlane& plane,
                     const RayScene& rays,
                     Random& random,
                     SyntheticScene& scene) {
  constexpr int kAttempts = 10;
  constexpr double kHalfModuleU = 0.5;
  constexpr double kHalfModuleV = 0.825;
  constexpr double kHalfGapM = 0.015;
  constexpr double kHeightM = 0.10;
  const int columns = random.integer(3, 7);
  const int rows = random.integer(1, 2);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Panel array = random_panel(plane, columns * kHalfModuleU, rows * kHalfModuleV, random);
    if (!is_free(rays, scene, array, plane.id)) continue;
    for (int i = 0; i < columns * rows; ++i) {
      const int column = i % columns;
      const int row = i / columns;
      const double s = (2.0 * column + 1.0) / columns - 1.0;
      const double t = (2.0 * row + 1.0) / rows - 1.0;
      const Panel module{array.at(s, t), array.u, array.v, kHalfModuleU - kHalfGapM,
                         kHalfModuleV - kHalfGapM};
      add_panel(module, kHeightM, {plane.building_id, kNone, Material::kSolar}, scene.mesh);
    }
    return true;
  }
  return false;
}

/// Adds a paved rectangle on the lawn if its place is free. Its sides are parallel to the nearest
/// house or randomly oriented.
void add_paving(const ScenePlane& plane,
                const RayScene& rays,
                Random& random,
                SyntheticScene& scene) {
  const double height_m = random.uniform(0.01, 0.05);  // overlapping ones must differ in height
  const double half_u_m = random.uniform(1.0, 3.0);
  const double half_v_m = random.uniform(0.6, 2.0);
  Panel panel = random_panel(plane, half_u_m, half_v_m, random);
  double azimuth = random.uniform(0.0, 3.2);
  double nearest_m = 15.0;
  for (const SceneBuilding& building : scene.buildings) {
    const double d = (building.footprint[0][0] - panel.centre.head<2>()).norm();
    if (d < nearest_m) {
      nearest_m = d;
      azimuth = building.ridge_azimuth_rad;
    }
  }
  const Eigen::Vector3d n = plane.plane.normal();
  const Eigen::Vector3d along(std::cos(azimuth), std::sin(azimuth), 0.0);
  panel.u = (along - along.dot(n) * n).normalized();
  panel.v = n.cross(panel.u);
  if (!is_free(rays, scene, panel, plane.id)) return;
  add_panel(panel, height_m, {kNone, kNone, Material::kPaving, next_object_id(scene.mesh)},
            scene.mesh);
}

}  // namespace

void add_fittings(SyntheticScene& scene, std::uint64_t seed) {
  constexpr double kMaxCosine = 0.995;  // cosine; flatter roofs have neither skylights nor panels
  constexpr double kSolarChance = 0.15;
  constexpr double kPavingPerM2 = 0.006;
  const Mesh bare = scene.mesh;
  const RayScene rays(bare);
  Random random({seed, kFittingsStream});
  for (const auto& [key, wall] : walls_of(scene)) {
    add_windows(wall, std::get<0>(key), random, scene.mesh);
  }
  for (const ScenePlane& plane : scene.planes) {
    if (plane.outline.empty()) continue;  // completely covered by other roof faces
    if (plane.kind == PlaneKind::kRoof && plane.plane.normal().z() < kMaxCosine) {
      const bool solar = random.chance(kSolarChance) && add_solar_array(plane, rays, random, scene);
      if (!solar) add_skylights(plane, rays, random, scene);
    } else if (plane.kind == PlaneKind::kGround) {
      const int count = static_cast<int>(kPavingPerM2 * scene.extent_m.prod());
      for (int i = 0; i < count; ++i) add_paving(plane, rays, random, scene);
    }
  }
}

}  // namespace ridgeline::simulate
