// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/footprint.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace ridgeline::evaluate {

Footprint footprint_of(const Segment3& segment) {
  Segment2 p = plan(segment);
  // the axes are the same regardless of which end the file gives first
  if (std::tuple(p.end.x(), p.end.y()) < std::tuple(p.start.x(), p.start.y())) {
    std::swap(p.start, p.end);
  }
  const double length_m = length(p);
  check(length_m > 0.0, "footprint_of: length in plan = ", length_m, " m, must be positive");
  const Eigen::Vector2d along = (p.end - p.start) / length_m;
  return {p.start, along, Eigen::Vector2d(-along.y(), along.x()), length_m};
}

std::vector<ZonePoint> points_beside(const PointSearch& search,
                                     const Footprint& footprint,
                                     double half_width_m,
                                     double end_m) {
  std::vector<ZonePoint> points;
  const Segment2 axis{footprint.at(-end_m), footprint.at(footprint.length_m + end_m)};
  search.visit_near(axis, half_width_m, [&](const PointSearch::Point& point) {
    const double s = footprint.s(point.x.head<2>());
    const double t = footprint.t(point.x.head<2>());
    if (std::abs(t) > half_width_m || s < -end_m || s > footprint.length_m + end_m) return;
    points.push_back({point.x, s, t, point.index});
  });
  std::sort(points.begin(), points.end(), [](const ZonePoint& a, const ZonePoint& b) {
    return std::tuple(a.x.x(), a.x.y(), a.x.z(), a.index) <
           std::tuple(b.x.x(), b.x.y(), b.x.z(), b.index);
  });
  const auto is_same_place = [](const ZonePoint& a, const ZonePoint& b) { return a.x == b.x; };
  points.erase(std::unique(points.begin(), points.end(), is_same_place), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) points[i].rank = static_cast<std::uint32_t>(i);
  return points;
}

}  // namespace ridgeline::evaluate
