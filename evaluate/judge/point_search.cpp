// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/point_search.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ridgeline::evaluate {

std::size_t PointSearch::count_within(const Eigen::Vector2d& x, double radius_m) const {
  std::vector<std::array<double, 3>> places;
  visit_near({x, x}, radius_m, [&](const Point& point) {
    if ((point.x.head<2>() - x).squaredNorm() > radius_m * radius_m) return;
    places.push_back({point.x.x(), point.x.y(), point.x.z()});
  });
  std::ranges::sort(places);
  const auto end = std::unique(places.begin(), places.end());
  return static_cast<std::size_t>(end - places.begin());
}

}  // namespace ridgeline::evaluate
