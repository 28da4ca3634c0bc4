// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ridgeline::evaluate {

/// A 2D grid of cells over a cloud in compressed row form: the points are stored cell by cell, so a
/// query reads consecutive memory. Built in O(n); a query's time depends on the local density only.
/// Within a cell points keep their input order, so results do not depend on threads.
class PointGrid {
 public:
  struct Point {
    Eigen::Vector3d x;    ///< local, m
    std::uint32_t index;  ///< in the input
  };

  /// `count` points, the i-th given by `x_in_local(i)` (Eigen::Vector3d); non-finite ones are left
  /// out. Cells are squares of `cell_m`, enlarged if the extent would need more than about four
  /// cells a point. Throws std::invalid_argument for 2^32 points or more, or a cell size <= 0.
  template <typename Accessor>
  static PointGrid build(std::size_t count, const Accessor& x_in_local, double cell_m = 1.0);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] double cell_m() const { return cell_m_; }

  /// Calls `visit(point)` for every point within `radius_m` of the segment in plan, and for some a
  /// little farther (whole cells): the caller applies its own exact test.
  template <typename Visitor>
  void visit_near(const Segment2& segment, double radius_m, Visitor&& visit) const;

  /// Number of points within `radius_m` of `x` in plan, bounds included; points at the same place are
  /// one.
  [[nodiscard]] std::size_t count_within(const Eigen::Vector2d& x, double radius_m) const;

 private:
  struct Extent {
    Eigen::Vector2d lowest, highest;
    std::size_t n_finite = 0;
  };
  void set_extent(const Extent& extent, double cell_m);
  [[nodiscard]] std::size_t cell_of(const Eigen::Vector3d& x) const;
  [[nodiscard]] std::ptrdiff_t column_of(double x) const;
  [[nodiscard]] std::ptrdiff_t row_of(double y) const;

  double cell_m_ = 1.0;
  Eigen::Vector2d lowest_ = Eigen::Vector2d::Zero();
  std::ptrdiff_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> cell_begin_;  ///< columns * rows + 1
  std::vector<Point> points_;
};

template <typename Accessor>
PointGrid PointGrid::build(std::size_t count, const Accessor& x_in_local, double cell_m) {
  check(count < (std::size_t{1} << 32U), "PointGrid: points = ", count, ", must be below 2^32");
  check(cell_m > 0.0, "PointGrid: cell_m = ", cell_m, ", must be positive");
  Extent extent{Eigen::Vector2d::Constant(HUGE_VAL), Eigen::Vector2d::Constant(-HUGE_VAL)};
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x = x_in_local(i);
    if (!x.allFinite()) continue;
    extent.lowest = extent.lowest.cwiseMin(x.head<2>());
    extent.highest = extent.highest.cwiseMax(x.head<2>());
    ++extent.n_finite;
  }
  PointGrid grid;
  grid.set_extent(extent, cell_m);
  // counting sort: sizes, then starts, then the points in input order
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x = x_in_local(i);
    if (x.allFinite()) ++grid.cell_begin_[grid.cell_of(x) + 1];
  }
  for (std::size_t c = 1; c < grid.cell_begin_.size(); ++c) {
    grid.cell_begin_[c] += grid.cell_begin_[c - 1];
  }
  std::vector<std::uint32_t> next(grid.cell_begin_.begin(), grid.cell_begin_.end() - 1);
  grid.points_.resize(extent.n_finite);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x = x_in_local(i);
    if (!x.allFinite()) continue;
    grid.points_[next[grid.cell_of(x)]++] = {x, static_cast<std::uint32_t>(i)};
  }
  return grid;
}

template <typename Visitor>
void PointGrid::visit_near(const Segment2& segment, double radius_m, Visitor&& visit) const {
  if (points_.empty()) return;
  const Eigen::Vector2d low = segment.start.cwiseMin(segment.end).array() - radius_m;
  const Eigen::Vector2d high = segment.start.cwiseMax(segment.end).array() + radius_m;
  const double reach = radius_m + cell_m_ * 0.7072;  // a cell's centre to its corner
  for (std::ptrdiff_t row = row_of(low.y()); row <= row_of(high.y()); ++row) {
    for (std::ptrdiff_t column = column_of(low.x()); column <= column_of(high.x()); ++column) {
      const Eigen::Vector2d centre =
          lowest_ + cell_m_ * Eigen::Vector2d(static_cast<double>(column) + 0.5,
                                              static_cast<double>(row) + 0.5);
      if (distance(segment, centre) > reach) continue;
      const auto cell = static_cast<std::size_t>(row * columns_ + column);
      for (std::uint32_t p = cell_begin_[cell]; p < cell_begin_[cell + 1]; ++p) visit(points_[p]);
    }
  }
}

}  // namespace ridgeline::evaluate
