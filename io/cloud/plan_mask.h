// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::io {

/// A coarse plan raster of the surroundings of line segments, to keep only the points near a line
/// while a cloud is read. It contains every point within `radius_m` of a segment, and points up to
/// about 2 cells farther away, so that a test is a single table look-up.
class PlanMask {
 public:
  /// Segments are in plan (x, y) of the local frame, metres. Without segments the mask is empty.
  /// Throws std::invalid_argument unless radius_m > 0 and all coordinates are finite and at most
  /// 1e8 m.
  PlanMask(std::span<const Segment2> segments_in_local, double radius_m);

  [[nodiscard]] bool contains(double x, double y) const {
    const double column = (x - min_.x()) * inverse_cell_;
    const double row = (y - min_.y()) * inverse_cell_;
    // The negated form treats NaN as outside.
    if (!(column >= 0.0 && row >= 0.0 && column < static_cast<double>(n_columns_) &&
          row < static_cast<double>(n_rows_))) {
      return false;
    }
    return cells_[static_cast<std::size_t>(row) * n_columns_ + static_cast<std::size_t>(column)] !=
           0;
  }

  /// Whether any marked cell overlaps the rectangle between two corners.
  [[nodiscard]] bool overlaps(const Eigen::Vector2d& min, const Eigen::Vector2d& max) const;

  [[nodiscard]] double cell_size_m() const { return 1.0 / inverse_cell_; }

 private:
  void lay_out(std::span<const Segment2> segments, double radius_m);
  void mark(const Segment2& segment, double radius_m);
  void mark_row(const Segment2& segment, double radius_m, std::size_t row);

  Eigen::Vector2d min_ = Eigen::Vector2d::Zero();
  double inverse_cell_ = 1.0;
  std::size_t n_columns_ = 0;
  std::size_t n_rows_ = 0;
  std::vector<std::uint8_t> cells_;  ///< row by row, 1 near a segment
};

}  // namespace ridgeline::io
