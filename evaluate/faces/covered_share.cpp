// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/covered_share.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// Positions on a square grid over a box, each in the middle of its cell.
class CellMiddles {
 public:
  CellMiddles(const Eigen::AlignedBox2d& box, double step_m) : lowest_(box.min()), step_m_(step_m) {
    columns_ = static_cast<int>(box.sizes().x() / step_m) + 1;
    rows_ = static_cast<int>(box.sizes().y() / step_m) + 1;
    covered_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  }

  /// Marks all positions within a circle.
  void cover(const Eigen::Vector2d& x, double radius_m) {
    const Eigen::Vector2d in_steps = (x - lowest_) / step_m_;
    const int r = static_cast<int>(radius_m / step_m_) + 1;
    const int column = static_cast<int>(in_steps.x()), row = static_cast<int>(in_steps.y());
    for (int j = std::max(0, row - r); j <= std::min(rows_ - 1, row + r); ++j) {
      for (int i = std::max(0, column - r); i <= std::min(columns_ - 1, column + r); ++i) {
        if ((at(i, j) - x).squaredNorm() <= radius_m * radius_m) covered_[index(i, j)] = 1;
      }
    }
  }

  [[nodiscard]] double covered_share_in(const PlanPolygon& polygon) const {
    int n_inside = 0, n_covered = 0;
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) {
        if (!polygon.contains(at(i, j))) continue;
        ++n_inside;
        n_covered += covered_[index(i, j)];
      }
    }
    return n_inside > 0 ? static_cast<double>(n_covered) / n_inside : 0.0;
  }

 private:
  [[nodiscard]] Eigen::Vector2d at(int column, int row) const {
    return lowest_ + step_m_ * Eigen::Vector2d(column + 0.5, row + 0.5);
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  Eigen::Vector2d lowest_;
  double step_m_;
  int columns_ = 0, rows_ = 0;
  std::vector<char> covered_;
};

}  // namespace

double covered_share(const PlanPolygon& polygon,
                     std::span<const Eigen::Vector2d> points,
                     double radius_m) {
  check(radius_m > 0.0, "covered_share: radius_m = ", radius_m, ", must be positive");
  constexpr double kMaxPlaces = 1e5;
  if (points.empty() || polygon.edges().empty()) return 0.0;
  const double coarsest_m = std::sqrt(polygon.box().sizes().prod() / kMaxPlaces);
  CellMiddles places(polygon.box(), std::max(0.5 * radius_m, coarsest_m));
  for (const Eigen::Vector2d& x : points) places.cover(x, radius_m);
  return places.covered_share_in(polygon);
}

}  // namespace ridgeline::evaluate
