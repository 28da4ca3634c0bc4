// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/faces/face_kinds.h"

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/faces/face_geometry.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace ridgeline {
namespace {

/// A point inside a face that is not vertical: the middle of the widest interval of a cut in x
/// direction near the middle of its ring.
std::optional<Eigen::Vector3d> inner_point(const Face& face, const Plane3& plane) {
  const auto [low, high] =
      std::ranges::minmax(face.rings.front(), {}, [](const Eigen::Vector3d& x) { return x.y(); });
  const double y = low.y() + 0.4637 * (high.y() - low.y());  // vertices seldom lie there
  std::vector<double> cuts;
  for (const Ring& ring : face.rings) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Eigen::Vector3d &a = ring[i], &b = ring[j];
      if ((a.y() > y) != (b.y() > y))
        cuts.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
  }
  std::ranges::sort(cuts);
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

}  // namespace

void state_kinds(std::span<Face> faces) {
  const auto planes = transformed(faces, [](const Face& face) { return *plane_of(face); });
  const auto by_place = BoxIndex2(
      transformed(faces, [](const Face& face) { return plan_box_of(face.rings.front()); }));
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].kind != FaceKind::kUnknown) continue;
    faces[i].kind = is_wall(planes[i]) ? FaceKind::kWall : FaceKind::kRoof;
    if (faces[i].kind == FaceKind::kRoof) unknown.push_back(i);
  }
  const auto is_above = [&](std::size_t i, const Eigen::Vector3d& x) {
    constexpr double kClear = 0.01;
    const double height = height_at(planes[i], x.head<2>());
    return faces[i].kind == FaceKind::kRoof && height > x.z() + kClear &&
           is_on_face(faces[i], planes[i], {x.x(), x.y(), height});
  };
  std::vector<std::size_t> ground;
  for (const std::size_t i : unknown) {
    const std::optional<Eigen::Vector3d> x = inner_point(faces[i], planes[i]);
    if (!x) continue;
    const Eigen::AlignedBox2d place(x->head<2>());
    if (std::ranges::any_of(by_place.near(place, 0.0),
                            [&](std::size_t j) { return j != i && is_above(j, *x); }))
      ground.push_back(i);
  }
  for (const std::size_t i : ground) faces[i].kind = FaceKind::kGround;
}

}  // namespace ridgeline
