// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/point_search.h"
#include "reconstruct/geometry/check.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ridgeline::evaluate {

/// A 2D grid of cells over a cloud in compressed row form: the points are stored cell by cell, so a
/// query reads consecutive memory. Built in O(n); the time of a query depends only on the local
/// density. Within a cell, points keep their input order, so results do not depend on threads.
class PointGrid final : public PointSearch {
 public:
  /// A grid of `count` points, the i-th given by `x_in_local(i)` (Eigen::Vector3d); non-finite
  /// points are ignored. Cells are squares of `cell_m`, enlarged if the extent would need more than
  /// about four cells per point. Throws std::invalid_argument for 2^32 points or more, or a cell
  /// size <= 0.
  template <typename Accessor>
  static PointGrid build(std::size_t count, const Accessor& x_in_local, double cell_m = 1.0);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] double cell_m() const { return cell_m_; }

 protected:
  void visit_runs_near(const Segment2& segment,
                       double radius_m,
                       const std::function<void(Run)>& visit) const override;

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

}  // namespace ridgeline::evaluate
