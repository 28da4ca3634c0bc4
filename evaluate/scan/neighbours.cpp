// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/neighbours.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridgeline::evaluate {
namespace {

/// The points by cell in compressed row form.
class CellGrid {
 public:
  explicit CellGrid(std::span<const Eigen::Vector3d> points) : points_(points) {
    constexpr double kPointsPerCell = 2.0, kMinCell_m = 0.05;
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector3d& x : points) box.extend(Eigen::Vector2d(x.head<2>()));
    lowest_ = box.min();
    const double area_m2 = box.sizes().prod();
    cell_m_ = std::sqrt(kPointsPerCell * area_m2 / static_cast<double>(points.size()));
    cell_m_ = std::max({cell_m_, kMinCell_m, box.sizes().maxCoeff() / kMaxCells});
    columns_ = static_cast<std::ptrdiff_t>(box.sizes().x() / cell_m_) + 1;
    rows_ = static_cast<std::ptrdiff_t>(box.sizes().y() / cell_m_) + 1;
    begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const Eigen::Vector3d& x : points) ++begin_[cell_of(x) + 1];
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    order_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      order_[next[cell_of(points[i])]++] = static_cast<std::uint32_t>(i);
  }

  using Near = std::pair<double, std::uint32_t>;  ///< squared distance, index

  /// Fills `near` with its size of neighbours, in ascending order.
  void find(const Eigen::Vector3d& x, std::span<Near> near) const {
    std::ranges::fill(near, Near(HUGE_VAL, 0));
    const std::ptrdiff_t column = column_of(x), row = row_of(x);
    for (std::ptrdiff_t ring = 0; ring <= std::max(columns_, rows_); ++ring) {
      // all points of this ring and beyond are at least this far away in plan
      const double reach_m = (static_cast<double>(ring) - 1.0) * cell_m_;
      if (ring > 1 && near.back().first <= reach_m * reach_m) return;
      visit_ring(column, row, ring, x, near);
    }
  }

 private:
  static constexpr double kMaxCells = 20000.0;

  [[nodiscard]] std::ptrdiff_t column_of(const Eigen::Vector3d& x) const {
    return static_cast<std::ptrdiff_t>((x.x() - lowest_.x()) / cell_m_);
  }
  [[nodiscard]] std::ptrdiff_t row_of(const Eigen::Vector3d& x) const {
    return static_cast<std::ptrdiff_t>((x.y() - lowest_.y()) / cell_m_);
  }
  [[nodiscard]] std::size_t cell_of(const Eigen::Vector3d& x) const {
    return static_cast<std::size_t>(row_of(x) * columns_ + column_of(x));
  }

  void visit_ring(std::ptrdiff_t column,
                  std::ptrdiff_t row,
                  std::ptrdiff_t ring,
                  const Eigen::Vector3d& x,
                  std::span<Near> near) const {
    for (std::ptrdiff_t r = std::max<std::ptrdiff_t>(row - ring, 0);
         r <= std::min(row + ring, rows_ - 1); ++r) {
      const bool whole = r == row - ring || r == row + ring;
      if (whole) {
        visit_cells(r, column - ring, column + ring, x, near);
      } else {
        visit_cells(r, column - ring, column - ring, x, near);
        visit_cells(r, column + ring, column + ring, x, near);
      }
    }
  }

  void visit_cells(std::ptrdiff_t row,
                   std::ptrdiff_t first,
                   std::ptrdiff_t last,
                   const Eigen::Vector3d& x,
                   std::span<Near> near) const {
    first = std::max<std::ptrdiff_t>(first, 0);
    last = std::min(last, columns_ - 1);
    if (first > last) return;
    const auto base = static_cast<std::size_t>(row * columns_);
    const std::uint32_t end = begin_[base + static_cast<std::size_t>(last) + 1];
    for (std::uint32_t k = begin_[base + static_cast<std::size_t>(first)]; k < end; ++k)
      insert({(points_[order_[k]] - x).squaredNorm(), order_[k]}, near);
  }

  static void insert(const Near& candidate, std::span<Near> near) {
    if (!(candidate < near.back())) return;
    std::size_t place = near.size() - 1;
    for (; place > 0 && candidate < near[place - 1]; --place) near[place] = near[place - 1];
    near[place] = candidate;
  }

  std::span<const Eigen::Vector3d> points_;
  Eigen::Vector2d lowest_;
  double cell_m_ = 1.0;
  std::ptrdiff_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begin_, order_;
};

}  // namespace

PointNeighbours nearest_neighbours(std::span<const Eigen::Vector3d> points, std::size_t per_point) {
  check(points.size() > per_point, "nearest_neighbours: points = ", points.size(),
        ", must be more than ", per_point);
  const CellGrid grid(points);
  PointNeighbours neighbours(points.size(), per_point);
  std::vector<CellGrid::Near> near(per_point);
  for (std::size_t i = 0; i < points.size(); ++i) {
    grid.find(points[i], near);
    std::ranges::transform(near, neighbours.of(i).begin(), &CellGrid::Near::second);
  }
  return neighbours;
}

}  // namespace ridgeline::evaluate
