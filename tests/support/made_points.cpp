// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/made_points.h"

#include "reconstruct/geometry/plane.h"
#include "tests/support/random.h"

#include <algorithm>
#include <optional>

namespace ridgeline::test {
namespace {

struct Surface {
  const MadeFace* face;
  Plane3 plane;
  Eigen::AlignedBox2d box;
};

Surface surface_of(const MadeFace& face) {
  const std::vector<Eigen::Vector3d>& ring = face.rings.front();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    normal += (ring[i] - ring[0]).cross(ring[(i + 1) % ring.size()] - ring[0]);
    box.extend(ring[i].head<2>());
  }
  return {&face, Plane3(normal.normalized(), ring[0]), box};
}

/// Even-odd rule over all rings, so that holes are outside.
bool is_over(const Surface& surface, const Eigen::Vector2d& x) {
  if (!surface.box.contains(x)) return false;
  bool inside = false;
  for (const std::vector<Eigen::Vector3d>& ring : surface.face->rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector3d& a = ring[i];
      const Eigen::Vector3d& b = ring[(i + 1) % ring.size()];
      if ((a.y() > x.y()) == (b.y() > x.y())) continue;
      inside ^= x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    }
  }
  return inside;
}

std::vector<Surface> roof_surfaces(std::span<const MadeBuilding> buildings) {
  std::vector<Surface> surfaces;
  for (const MadeBuilding& building : buildings) {
    for (const MadeFace& face : building.faces) {
      if (face.kind == MadeSurface::kRoof) surfaces.push_back(surface_of(face));
    }
  }
  return surfaces;
}

/// The ground's plane at a place.
Plane3 ground_at(std::span<const MadeBuilding> buildings, const Eigen::Vector2d& x) {
  const auto distance = [&](const MadeBuilding& building) {
    return (building.spec.position.head<2>() - x).squaredNorm();
  };
  const auto nearest = std::ranges::min_element(buildings, {}, distance);
  return {Eigen::Vector3d::UnitZ(), nearest->spec.position};
}

Plane3 top_plane(std::span<const MadeBuilding> buildings,
                 const std::vector<Surface>& surfaces,
                 const Eigen::Vector2d& x) {
  std::optional<Plane3> top;
  for (const Surface& surface : surfaces) {
    if (!is_over(surface, x)) continue;
    if (!top || height_at(surface.plane, x) > height_at(*top, x)) top = surface.plane;
  }
  return top ? *top : ground_at(buildings, x);
}

}  // namespace

std::vector<Eigen::Vector3d> scan(std::span<const MadeBuilding> buildings, const ScanSpec& spec) {
  const std::vector<Surface> surfaces = roof_surfaces(buildings);
  Eigen::AlignedBox2d box;
  for (const Surface& surface : surfaces) box.extend(surface.box);
  const Eigen::Vector2d low = box.min().array() - spec.margin_m;
  const Eigen::Vector2d size = box.sizes().array() + 2.0 * spec.margin_m;
  Random random(spec.seed);
  std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(spec.points_per_m2 * size.prod()));
  for (Eigen::Vector3d& point : points) {
    const double u = random.uniform(0.0, 1.0);
    const Eigen::Vector2d x = low + size.cwiseProduct(Eigen::Vector2d(u, random.uniform(0.0, 1.0)));
    const Plane3 plane = top_plane(buildings, surfaces, x);
    const Eigen::Vector3d error = spec.noise == NoiseDirection::kNormal
                                      ? Eigen::Vector3d(plane.normal())
                                      : Eigen::Vector3d::UnitZ();
    point << x, height_at(plane, x);
    point += random.normal(spec.sigma_m) * error;
  }
  return points;
}

}  // namespace ridgeline::test
