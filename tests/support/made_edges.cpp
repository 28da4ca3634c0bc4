// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/made_buildings.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace ridgeline::test {
namespace {

constexpr double kLevel = 1e-9;  // rise of an edge or tilt of a face that is rounding

/// An edge of a face, which runs as the face's ring does.
struct HalfEdge {
  Eigen::Vector3d from, to;
  MadeSurface kind;
  Eigen::Vector3d normal;  ///< of its face, outwards
};

Eigen::Vector3d normal_of(const MadeFace& face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const std::vector<Eigen::Vector3d>& ring = face.rings.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += (ring[i] - ring[0]).cross(ring[(i + 1) % ring.size()] - ring[0]);
  }
  return sum.normalized();
}

std::vector<HalfEdge> half_edges_of(const std::vector<MadeFace>& faces) {
  std::vector<HalfEdge> edges;
  for (const MadeFace& face : faces) {
    const Eigen::Vector3d normal = normal_of(face);
    for (const std::vector<Eigen::Vector3d>& ring : face.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        edges.push_back({ring[i], ring[(i + 1) % ring.size()], face.kind, normal});
      }
    }
  }
  return edges;
}

/// How far the other face of an edge rises above this one per metre away from their edge: below 0
/// if the edge is convex.
double rise_of_other(const HalfEdge& edge, const HalfEdge& other) {
  const Eigen::Vector3d into_other = other.normal.cross(other.to - other.from).normalized();
  return edge.normal.dot(into_other);
}

MadeEdgeKind kind_between_roofs(const HalfEdge& edge, double rise) {
  if (rise > 0.0) return MadeEdgeKind::kValley;
  return std::abs(edge.to.z() - edge.from.z()) < kLevel ? MadeEdgeKind::kRidge : MadeEdgeKind::kHip;
}

MadeEdgeKind kind_at_wall(const HalfEdge& edge, double rise) {
  const Eigen::Vector2d tilt = edge.normal.head<2>();
  if (rise > 0.0 || tilt.norm() < kLevel) return MadeEdgeKind::kStep;
  const Eigen::Vector2d along = (edge.to - edge.from).head<2>().normalized();
  const bool across = std::abs(along.dot(tilt.normalized())) < std::numbers::sqrt2 / 2.0;
  return across ? MadeEdgeKind::kEave : MadeEdgeKind::kVerge;
}

/// The kind of the edge of a roof face and another one; nothing if both are one plane.
std::optional<MadeEdgeKind> kind_of(const HalfEdge& edge, const HalfEdge& other) {
  const double rise = rise_of_other(edge, other);
  if (other.kind == MadeSurface::kWall) return kind_at_wall(edge, rise);
  if (std::abs(rise) < kLevel) return std::nullopt;
  return kind_between_roofs(edge, rise);
}

}  // namespace

std::vector<MadeEdge> roof_edges(const std::vector<MadeFace>& faces) {
  const std::vector<HalfEdge> all = half_edges_of(faces);
  const auto place = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::tuple(a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
  };
  std::map<std::tuple<double, double, double, double, double, double>, std::size_t> by_place;
  for (std::size_t i = 0; i < all.size(); ++i) by_place[place(all[i].from, all[i].to)] = i;
  std::vector<MadeEdge> edges;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t duplicate = by_place.at(place(all[i].to, all[i].from));
    const bool between_roofs = all[duplicate].kind == MadeSurface::kRoof;
    if (all[i].kind != MadeSurface::kRoof || (between_roofs && duplicate < i)) continue;
    const std::optional<MadeEdgeKind> kind = kind_of(all[i], all[duplicate]);
    if (kind) edges.push_back({*kind, {all[i].from, all[i].to}});
  }
  return edges;
}

}  // namespace ridgeline::test
