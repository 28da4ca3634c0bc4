// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/face_points.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace ridgeline::evaluate {
Corridor corridor_of(const Eigen::AlignedBox2d& box) {
  const Eigen::Vector2d half = 0.5 * box.sizes();
  const bool wide = half.x() >= half.y();
  const Eigen::Vector2d along =
      wide ? Eigen::Vector2d(half.x(), 0.0) : Eigen::Vector2d(0.0, half.y());
  return {{box.center() - along, box.center() + along}, wide ? half.y() : half.x()};
}

std::vector<FacePoint> points_around(const PointSearch& search,
                                     const RoofFace& face,
                                     double reach_m) {
  const Corridor corridor = corridor_of(face.plan.box());
  std::vector<FacePoint> found;
  search.visit_near(corridor.axis, corridor.half_width_m + reach_m,
                    [&](const PointSearch::Point& p) {
                      const Eigen::Vector2d x = p.x.head<2>();
                      const bool inside = face.plan.contains(x);
                      const PlanPolygon::Nearest nearest = face.plan.nearest(x);
                      if (!inside && nearest.distance_m > reach_m) return;
                      const Eigen::Vector2d offset = x - face.centroid.head<2>();
                      found.push_back({{p.x, offset.x(), offset.y(), p.index},
                                       inside ? -nearest.distance_m : nearest.distance_m,
                                       nearest.edge,
                                       nearest.beside});
                    });
  const auto place = [](const FacePoint& p) {
    return std::tuple(p.point.x.x(), p.point.x.y(), p.point.x.z());
  };
  std::ranges::sort(found, [&](const FacePoint& a, const FacePoint& b) {
    return std::tuple(place(a), a.point.index) < std::tuple(place(b), b.point.index);
  });
  const auto is_same = [&](const FacePoint& a, const FacePoint& b) { return place(a) == place(b); };
  found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
  for (std::uint32_t i = 0; i < found.size(); ++i) found[i].point.rank = i;
  return found;
}

}  // namespace ridgeline::evaluate
