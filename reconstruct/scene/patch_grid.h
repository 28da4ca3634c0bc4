// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>

namespace ridgeline::reconstruct {

/// A square of a grid; its patch is named after it.
struct GridCell {
  std::int64_t column = 0, row = 0;
  auto operator<=>(const GridCell&) const = default;
};

/// Squares at multiples of their size, so that they keep their positions when a block grows. The
/// first and the last column and row of an extent are joined to their neighbours if they are
/// slivers, because the overlap of the neighbouring patch covers them anyway.
class PatchGrid {
 public:
  explicit PatchGrid(double size_m) : size_m_(size_m) {}

  /// @param extent     the extent of all places, m
  /// @param overlap_m  the distance by which a patch extends beyond its square
  PatchGrid(double size_m, const Eigen::AlignedBox2d& extent, double overlap_m)
      : size_m_(size_m),
        first_(plain_cell_of(extent.min())),
        last_(plain_cell_of(extent.max())),
        first_kept_(first_),
        last_kept_(last_) {
    const double widest_m = sliver_m(overlap_m);
    const Eigen::Vector2d low = corner(first_).array() + size_m_ - extent.min().array();
    const Eigen::Vector2d high = extent.max() - corner(last_);
    const auto join = [&](std::int64_t& first, std::int64_t& last, double low_m, double high_m) {
      if (first < last && low_m <= widest_m) ++first;
      if (first < last && high_m <= widest_m) --last;
    };
    join(first_kept_.column, last_kept_.column, low.x(), high.x());
    join(first_kept_.row, last_kept_.row, low.y(), high.y());
  }

  /// The largest width of a sliver: the overlap, but at least 2 m, because narrower patches are not
  /// worthwhile.
  static double sliver_m(double overlap_m) {
    constexpr double kMinSliver_m = 2.0;
    return std::max(overlap_m, kMinSliver_m);
  }

  [[nodiscard]] double size_m() const { return size_m_; }

  /// The square to which a place belongs; for a place on a side, the upper or right one.
  [[nodiscard]] GridCell cell_of(const Eigen::Vector2d& x_in_world) const {
    const GridCell cell = plain_cell_of(x_in_world);
    const auto joined = [](std::int64_t place, std::int64_t first, std::int64_t last,
                           std::int64_t first_kept, std::int64_t last_kept) {
      return place < first || place > last ? place : std::clamp(place, first_kept, last_kept);
    };
    return {joined(cell.column, first_.column, last_.column, first_kept_.column, last_kept_.column),
            joined(cell.row, first_.row, last_.row, first_kept_.row, last_kept_.row)};
  }

  /// The square, including the slivers that are joined to it.
  [[nodiscard]] Eigen::AlignedBox2d square(const GridCell& cell) const {
    const GridCell low{cell.column == first_kept_.column ? first_.column : cell.column,
                       cell.row == first_kept_.row ? first_.row : cell.row};
    const GridCell high{cell.column == last_kept_.column ? last_.column : cell.column,
                        cell.row == last_kept_.row ? last_.row : cell.row};
    return {corner(low), Eigen::Vector2d(corner(high).array() + size_m_)};
  }

 private:
  using Limits = std::numeric_limits<std::int64_t>;

  [[nodiscard]] GridCell plain_cell_of(const Eigen::Vector2d& x) const {
    return {static_cast<std::int64_t>(std::floor(x.x() / size_m_)),
            static_cast<std::int64_t>(std::floor(x.y() / size_m_))};
  }
  [[nodiscard]] Eigen::Vector2d corner(const GridCell& cell) const {
    return {size_m_ * static_cast<double>(cell.column), size_m_ * static_cast<double>(cell.row)};
  }

  double size_m_;
  GridCell first_{Limits::min(), Limits::min()}, last_{Limits::max(), Limits::max()};
  GridCell first_kept_ = first_, last_kept_ = last_;  ///< without slivers
};

}  // namespace ridgeline::reconstruct
