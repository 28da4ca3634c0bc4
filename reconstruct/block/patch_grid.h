// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <compare>
#include <cstdint>

namespace ridgeline::reconstruct {

/// A square of a grid; its patch has the same name.
struct GridCell {
  std::int64_t column = 0, row = 0;
  auto operator<=>(const GridCell&) const = default;
};

/// Squares that lie at multiples of their size, so that they stay where they are when a block grows.
struct PatchGrid {
  double size_m = 0.0;

  /// The square that a place belongs to; of places on a side it is the upper or right one.
  [[nodiscard]] GridCell cell_of(const Eigen::Vector2d& x_in_world) const {
    return {static_cast<std::int64_t>(std::floor(x_in_world.x() / size_m)),
            static_cast<std::int64_t>(std::floor(x_in_world.y() / size_m))};
  }
  [[nodiscard]] Eigen::AlignedBox2d square(const GridCell& cell) const {
    const Eigen::Vector2d corner(size_m * static_cast<double>(cell.column),
                                 size_m * static_cast<double>(cell.row));
    return {corner, Eigen::Vector2d(corner.array() + size_m)};
  }
};

}  // namespace ridgeline::reconstruct
