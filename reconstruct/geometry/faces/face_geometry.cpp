// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/faces/face_geometry.h"

#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>

namespace ridgeline {
namespace {

/// Counts the crossings of the ring, in the plane of axes u and v, with a ray from x towards larger
/// u.
bool is_in_ring(const Ring& ring, const Eigen::Vector3d& x, int u, int v) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Eigen::Vector3d a = ring[i] - x, b = ring[j] - x;
    if ((a[v] > 0.0) == (b[v] > 0.0)) continue;
    if (a[u] + (b[u] - a[u]) * a[v] / (a[v] - b[v]) > 0.0) inside = !inside;
  }
  return inside;
}

}  // namespace

std::optional<Plane3> plane_of(const Face& face) {
  constexpr double kMinArea_m2 = 1e-6;  // 1 mm x 1 mm
  const Ring& ring = face.rings.front();
  const Eigen::Vector3d area = area_vector(ring);
  const double size = area.norm();
  if (!(size > kMinArea_m2) || !std::isfinite(size)) return std::nullopt;
  return Plane3(area / size, mean_of(ring));
}

bool is_wall(const Plane3& plane) {
  constexpr double kMaxRoofSlope_rad = 80.0 * kRadPerDeg;
  return slope_rad(plane) > kMaxRoofSlope_rad;
}

bool is_on_face(const Face& face, const Plane3& plane, const Eigen::Vector3d& x) {
  int axis = 0;
  plane.normal().cwiseAbs().maxCoeff(&axis);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  bool inside = false;
  for (const Ring& ring : face.rings) inside = inside != is_in_ring(ring, x, u, v);
  return inside;
}

std::optional<Eigen::Vector3d> inward_of(const Face& face,
                                         const Plane3& plane,
                                         const Segment3& edge) {
  constexpr double kStep = 0.02;
  const Eigen::Vector3d across = plane.normal().cross(edge.end - edge.start).normalized();
  const Eigen::Vector3d middle = plane.projection(midpoint(edge));
  const bool is_left = is_on_face(face, plane, middle + kStep * across);
  const bool is_right = is_on_face(face, plane, middle - kStep * across);
  if (is_left == is_right) return std::nullopt;
  return is_left ? across : Eigen::Vector3d(-across);
}

Outline outline_of(const Ring& ring) {
  Outline outline;
  for (const Eigen::Vector3d& x : ring) {
    const Eigen::Vector3d mm = (1000.0 * x).array().round();
    outline.push_back({mm.x(), mm.y(), mm.z()});
  }
  std::ranges::sort(outline);
  return outline;
}

}  // namespace ridgeline
