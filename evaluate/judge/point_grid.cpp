// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/point_grid.h"

#include <algorithm>
#include <array>

namespace ridgeline::evaluate {
namespace {

/// Index of the cell that holds `offset_m`, clamped to the grid: far coordinates must not overflow.
std::ptrdiff_t clamped_cell(double offset_m, double cell_m, std::ptrdiff_t count) {
  const double cell = std::floor(offset_m / cell_m);
  return static_cast<std::ptrdiff_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

void PointGrid::set_extent(const Extent& extent, double cell_m) {
  cell_m_ = cell_m;
  if (extent.n_finite == 0) {
    cell_begin_.assign(1, 0);
    return;
  }
  lowest_ = extent.lowest;
  const Eigen::Vector2d size = extent.highest - extent.lowest;
  // two distant points must not make a grid of billions of empty cells
  const double most_cells = 4.0 * static_cast<double>(extent.n_finite) + 1024.0;
  const auto cells = [&](double c) { return (size.x() / c + 1.0) * (size.y() / c + 1.0); };
  while (cells(cell_m_) > most_cells) cell_m_ *= 2.0;
  columns_ = static_cast<std::ptrdiff_t>(size.x() / cell_m_) + 1;
  rows_ = static_cast<std::ptrdiff_t>(size.y() / cell_m_) + 1;
  cell_begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
}

std::ptrdiff_t PointGrid::column_of(double x) const {
  return clamped_cell(x - lowest_.x(), cell_m_, columns_);
}
std::ptrdiff_t PointGrid::row_of(double y) const {
  return clamped_cell(y - lowest_.y(), cell_m_, rows_);
}
std::size_t PointGrid::cell_of(const Eigen::Vector3d& x) const {
  return static_cast<std::size_t>(row_of(x.y()) * columns_ + column_of(x.x()));
}

std::size_t PointGrid::count_within(const Eigen::Vector2d& x, double radius_m) const {
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
