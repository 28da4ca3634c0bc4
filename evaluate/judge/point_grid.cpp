// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/point_grid.h"

#include <algorithm>

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
  // two distant points must not produce a grid of billions of empty cells
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

void PointGrid::visit_runs_near(const Segment2& segment,
                                double radius_m,
                                const std::function<void(Run)>& visit) const {
  if (points_.empty()) return;
  const Eigen::Vector2d low = segment.start.cwiseMin(segment.end).array() - radius_m;
  const Eigen::Vector2d high = segment.start.cwiseMax(segment.end).array() + radius_m;
  const double reach = radius_m + cell_m_ * 0.7072;  // a cell's centre to its corner
  for (std::ptrdiff_t row = row_of(low.y()); row <= row_of(high.y()); ++row) {
    // the cells near a segment are contiguous in a row, and so are their points
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    for (std::ptrdiff_t column = column_of(low.x()); column <= column_of(high.x()); ++column) {
      const Eigen::Vector2d centre =
          lowest_ + cell_m_ * Eigen::Vector2d(static_cast<double>(column) + 0.5,
                                              static_cast<double>(row) + 0.5);
      if (distance(segment, centre) > reach) continue;
      const auto cell = static_cast<std::size_t>(row * columns_ + column);
      if (begin == end) begin = cell_begin_[cell];
      end = cell_begin_[cell + 1];
    }
    if (begin != end) visit(Run(points_).subspan(begin, end - begin));
  }
}

}  // namespace ridgeline::evaluate
