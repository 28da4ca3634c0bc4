// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/shown_cloud.h"

#include "io/crs/crs.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::apps {
namespace {

struct Box {
  Eigen::Vector2d low, high;
};

Box box_of(const std::vector<io::CloudPoint>& points) {
  Box box{Eigen::Vector2d::Constant(HUGE_VAL), Eigen::Vector2d::Constant(-HUGE_VAL)};
  for (const io::CloudPoint& p : points) {
    const Eigen::Vector2d x(p.x, p.y);
    box = {box.low.cwiseMin(x), box.high.cwiseMax(x)};
  }
  return box;
}

struct Density {
  double points_per_m2 = 0.0, no_data_share = 0.0;
};

/// The density, and the share of cells without points. If `points` are only a `share` of the cloud,
/// the cells are larger, so that as many of them contain a point.
Density density_of(const std::vector<io::CloudPoint>& points, double share) {
  constexpr double kMaxCells = 1e7;
  const auto [low, high] = box_of(points);
  const Eigen::Vector2d extent = (high - low).cwiseMax(1.0);
  const double cell_m = std::max(1.0 / std::sqrt(share), std::sqrt(extent.prod() / kMaxCells));
  const Eigen::Vector2i n = (extent / cell_m).array().ceil().cast<int>();
  std::vector<char> occupied(static_cast<std::size_t>(n.x()) * static_cast<std::size_t>(n.y()), 0);
  for (const io::CloudPoint& p : points) {
    const int column = std::clamp(static_cast<int>((p.x - low.x()) / cell_m), 0, n.x() - 1);
    const int row = std::clamp(static_cast<int>((p.y - low.y()) / cell_m), 0, n.y() - 1);
    occupied[static_cast<std::size_t>(row) * static_cast<std::size_t>(n.x()) +
             static_cast<std::size_t>(column)] = 1;
  }
  const auto n_occupied =
      static_cast<double>(std::count(occupied.begin(), occupied.end(), char{1}));
  return {static_cast<double>(points.size()) / (share * n_occupied * cell_m * cell_m),
          1.0 - n_occupied / static_cast<double>(occupied.size())};
}

}  // namespace

ShownCloud shown_cloud(const io::PointCloud& cloud, bool is_masked) {
  ShownCloud shown;
  shown.crs = io::describe(cloud.crs).name;
  shown.n_read = cloud.n_read;
  const std::size_t n_here = cloud.points.size();
  shown.n_all = n_here + cloud.n_dropped_share;
  if (n_here == 0) return shown;
  const Density density =
      density_of(cloud.points, static_cast<double>(n_here) / static_cast<double>(shown.n_all));
  shown.points_per_m2 = density.points_per_m2;
  if (!is_masked) shown.no_data_share = density.no_data_share;
  const std::size_t step =
      std::max<std::size_t>(1, (n_here + kMaxReportPoints - 1) / kMaxReportPoints);
  shown.x_in_local.reserve(n_here / step + 1);
  for (std::size_t i = 0; i < n_here; i += step) {
    const io::CloudPoint& p = cloud.points[i];
    shown.x_in_local.emplace_back(p.x, p.y, p.z);
  }
  return shown;
}

}  // namespace ridgeline::apps
