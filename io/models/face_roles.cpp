// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/face_roles.h"

#include "reconstruct/geometry/transformed.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace ridgeline::io {
namespace {

constexpr double kSteepestRoof_rad = 80.0 * std::numbers::pi / 180.0;

/// Twice the vector area. Relative to the first vertex, as world coordinates would cost digits.
Eigen::Vector3d doubled_area(const Ring& ring) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += (ring[i] - ring[0]).cross(ring[i + 1] - ring[0]);
  return sum;
}

/// The crossings of a ray in the plane of two axes, to the side of larger u.
bool is_in_ring(const Ring& ring, const Eigen::Vector3d& x, int u, int v) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Eigen::Vector3d a = ring[i] - x, b = ring[j] - x;
    if ((a[v] > 0.0) == (b[v] > 0.0)) continue;
    if (a[u] + (b[u] - a[u]) * a[v] / (a[v] - b[v]) > 0.0) inside = !inside;
  }
  return inside;
}

/// A point inside of a face that is not vertical: the middle of the widest stretch of a level cut through the middle of its ring.
std::optional<Eigen::Vector3d> inner_point(const ModelFace& face, const Plane3& plane) {
  const Ring& outer = face.rings.front();
  double low = outer[0].y(), high = low;
  for (const Eigen::Vector3d& x : outer) {
    low = std::min(low, x.y());
    high = std::max(high, x.y());
  }
  const double y = low + 0.4637 * (high - low);  // vertices seldom lie there
  std::vector<double> cuts;
  for (const Ring& ring : face.rings) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Eigen::Vector3d &a = ring[i], &b = ring[j];
      if ((a.y() > y) != (b.y() > y))
        cuts.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
  }
  std::sort(cuts.begin(), cuts.end());
  double widest = 0.0;
  std::optional<Eigen::Vector3d> point;
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
    if (cuts[i + 1] - cuts[i] <= widest) continue;
    widest = cuts[i + 1] - cuts[i];
    const Eigen::Vector2d middle(0.5 * (cuts[i] + cuts[i + 1]), y);
    point = Eigen::Vector3d(middle.x(), middle.y(), height_at(plane, middle));
  }
  return point;
}

/// Finds the faces whose bounding box in plan may hold a point: as many cells as there are faces list those that touch them.
class FacesByPlace {
 public:
  explicit FacesByPlace(std::span<const ModelFace> faces) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const ModelFace& face : faces) {
      Eigen::AlignedBox2d& box = boxes.emplace_back();
      for (const Eigen::Vector3d& x : face.rings.front())
        if (x.allFinite()) box.extend(x.head<2>());
      if (!box.isEmpty()) extent_.extend(box);
    }
    n_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(faces.size()))));
    cells_.resize(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].isEmpty()) continue;
      const Eigen::Vector2i low = cell_of(boxes[i].min()), high = cell_of(boxes[i].max());
      for (int u = low.x(); u <= high.x(); ++u)
        for (int v = low.y(); v <= high.y(); ++v) cell(u, v).push_back(i);
    }
  }

  [[nodiscard]] const std::vector<std::size_t>& at(const Eigen::Vector2d& x) const {
    const Eigen::Vector2i c = cell_of(x);
    return cells_[place(c.x(), c.y())];
  }

 private:
  [[nodiscard]] Eigen::Vector2i cell_of(const Eigen::Vector2d& x) const {
    const Eigen::Array2d share = (x - extent_.min()).array() / extent_.sizes().array().max(1e-9);
    // NaN, of an extent that is not finite, goes to the first cell.
    return (share >= 0.0).select((share * n_).min(n_ - 1.0), 0.0).cast<int>().matrix();
  }
  [[nodiscard]] std::size_t place(int u, int v) const {
    return static_cast<std::size_t>(u) * static_cast<std::size_t>(n_) + static_cast<std::size_t>(v);
  }
  std::vector<std::size_t>& cell(int u, int v) { return cells_[place(u, v)]; }

  Eigen::AlignedBox2d extent_;
  int n_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace

std::optional<Plane3> plane_of(const ModelFace& face) {
  const Ring& ring = face.rings.front();
  if (ring.size() < 3) return std::nullopt;
  const Eigen::Vector3d area = doubled_area(ring);
  const double norm = area.norm();
  constexpr double kLeast = 2e-6;  // a mm by a mm
  if (!(norm > kLeast) || !std::isfinite(norm)) return std::nullopt;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : ring) middle += (x - ring[0]) / static_cast<double>(ring.size());
  return Plane3(area / norm, ring[0] + middle);
}

std::optional<Eigen::Vector3d> inward_of(const ModelFace& face,
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

bool is_wall(const Plane3& plane) { return slope_rad(plane) > kSteepestRoof_rad; }

bool is_on_face(const ModelFace& face, const Plane3& plane, const Eigen::Vector3d& x) {
  int axis = 0;
  plane.normal().cwiseAbs().maxCoeff(&axis);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  bool inside = false;
  for (const Ring& ring : face.rings) inside = inside != is_in_ring(ring, x, u, v);
  return inside;
}

std::vector<SurfaceKind> roles_of(std::span<const ModelFace> faces,
                                  std::span<const std::optional<Plane3>> planes) {
  std::vector<SurfaceKind> roles;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool is_steep = planes[i] && is_wall(*planes[i]);
    roles.push_back(!planes[i]                               ? SurfaceKind::kOther
                    : faces[i].kind != SurfaceKind::kUnknown ? faces[i].kind
                    : is_steep                               ? SurfaceKind::kWall
                                                             : SurfaceKind::kRoof);
  }
  const std::vector<SurfaceKind> first = roles;
  const FacesByPlace by_place(faces);
  const auto is_above = [&](std::size_t i, const Eigen::Vector3d& x) {
    if (first[i] != SurfaceKind::kRoof) return false;
    constexpr double kClear = 0.01;
    const double height = height_at(*planes[i], x.head<2>());
    return height > x.z() + kClear && is_on_face(faces[i], *planes[i], {x.x(), x.y(), height});
  };
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (first[i] != SurfaceKind::kRoof || faces[i].kind != SurfaceKind::kUnknown) continue;
    const std::optional<Eigen::Vector3d> x = inner_point(faces[i], *planes[i]);
    if (!x) continue;
    if (std::ranges::any_of(by_place.at(x->head<2>()),
                            [&](std::size_t j) { return j != i && is_above(j, *x); }))
      roles[i] = SurfaceKind::kGround;
  }
  return roles;
}

std::vector<SurfaceKind> roles_of(const BuildingModel& model) {
  const std::span<const ModelFace> faces = model.faces;
  std::vector<SurfaceKind> roles;
  for (std::size_t first = 0; first < faces.size();) {
    std::size_t last = first;
    while (last < faces.size() && faces[last].building == faces[first].building) ++last;
    const std::span<const ModelFace> of_building = faces.subspan(first, last - first);
    std::ranges::copy(roles_of(of_building, transformed(of_building, plane_of)),
                      std::back_inserter(roles));
    first = last;
  }
  return roles;
}

}  // namespace ridgeline::io
