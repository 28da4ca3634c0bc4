// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/plan_mask.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridgeline::io {

namespace {

constexpr double kMaxMaskCoordinate_m = 1e8;  // also the limit for the coordinates of clouds
constexpr double kMaxCells = 6.4e7;           // 64 MB; lines spread wider get coarser cells

/// The parameters [t0, t1] of a segment at which its y lies in [low, high]; empty (t0 > t1) if
/// there are none.
std::pair<double, double> clip_to_band(const Segment2& segment, double low, double high) {
  const double rise = segment.end.y() - segment.start.y();
  if (rise == 0.0) {
    const bool inside = segment.start.y() >= low && segment.start.y() <= high;
    return inside ? std::pair{0.0, 1.0} : std::pair{1.0, 0.0};
  }
  const auto [t_first, t_last] =
      std::minmax({(low - segment.start.y()) / rise, (high - segment.start.y()) / rise});
  return {std::max(0.0, t_first), std::min(1.0, t_last)};
}

}  // namespace

PlanMask::PlanMask(std::span<const Segment2> segments_in_local, double radius_m) {
  check(std::isfinite(radius_m) && radius_m > 0.0, "PlanMask: radius_m = ", radius_m,
        ", must be positive and finite");
  for (const Segment2& segment : segments_in_local) {
    const Eigen::Array4d x(segment.start.x(), segment.start.y(), segment.end.x(), segment.end.y());
    check((x.abs() <= kMaxMaskCoordinate_m).all(),
          "PlanMask: coordinates of a segment = ", x.transpose(), ", must be finite and at most ",
          kMaxMaskCoordinate_m);
  }
  if (segments_in_local.empty()) return;
  lay_out(segments_in_local, radius_m);
  for (const Segment2& segment : segments_in_local) mark(segment, radius_m);
}

bool PlanMask::overlaps(const Eigen::Vector2d& min, const Eigen::Vector2d& max) const {
  const Eigen::Array2d size(static_cast<double>(n_columns_), static_cast<double>(n_rows_));
  const Eigen::Array2d first = ((min - min_).array() * inverse_cell_).floor().max(0.0);
  const Eigen::Array2d last = ((max - min_).array() * inverse_cell_).floor().min(size - 1.0);
  if (!(first <= last).all()) return false;
  const auto first_column = static_cast<std::ptrdiff_t>(first.x());
  const auto last_column = static_cast<std::ptrdiff_t>(last.x());
  for (auto row = static_cast<std::size_t>(first.y()); row <= static_cast<std::size_t>(last.y());
       ++row) {
    const auto begin = cells_.begin() + static_cast<std::ptrdiff_t>(row * n_columns_);
    const auto end = begin + last_column + 1;
    if (std::find(begin + first_column, end, std::uint8_t{1}) != end) return true;
  }
  return false;
}

void PlanMask::lay_out(std::span<const Segment2> segments, double radius_m) {
  Eigen::AlignedBox2d box;
  for (const Segment2& segment : segments) box.extend(segment.start).extend(segment.end);
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(radius_m);
  min_ = box.min() - margin;
  const Eigen::Vector2d size = box.max() + margin - min_;
  const double cell = std::max(0.5 * radius_m, std::sqrt(size.prod() / kMaxCells));
  inverse_cell_ = 1.0 / cell;
  n_columns_ = static_cast<std::size_t>(size.x() * inverse_cell_) + 1;
  n_rows_ = static_cast<std::size_t>(size.y() * inverse_cell_) + 1;
  cells_.assign(n_columns_ * n_rows_, 0);
}

void PlanMask::mark(const Segment2& segment, double radius_m) {
  const auto [low, high] = std::minmax(segment.start.y(), segment.end.y());
  const auto row_of = [&](double y) {
    const double row = std::floor((y - min_.y()) * inverse_cell_);
    return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(n_rows_ - 1)));
  };
  const std::size_t last = row_of(high + radius_m);
  for (std::size_t row = row_of(low - radius_m); row <= last; ++row) {
    mark_row(segment, radius_m, row);
  }
}

/// Marks the cells of a row that may hold points within the radius. Such a point is near the part
/// of the segment that lies in the row's band widened by the radius, so the row's cells up to the
/// radius from that part are marked.
void PlanMask::mark_row(const Segment2& segment, double radius_m, std::size_t row) {
  const double cell = cell_size_m();
  const double row_low = min_.y() + static_cast<double>(row) * cell;
  // A thousandth of a cell absorbs the rounding of the look-up.
  const double slack = 1e-3 * cell;
  const auto [t0, t1] =
      clip_to_band(segment, row_low - radius_m - slack, row_low + cell + radius_m + slack);
  if (t0 > t1) return;
  const auto [x_low, x_high] = std::minmax({std::lerp(segment.start.x(), segment.end.x(), t0),
                                            std::lerp(segment.start.x(), segment.end.x(), t1)});
  const auto column_of = [&](double x) {
    const double column = std::floor((x - min_.x()) * inverse_cell_);
    return static_cast<std::ptrdiff_t>(
        std::clamp(column, 0.0, static_cast<double>(n_columns_ - 1)));
  };
  const auto row_begin = cells_.begin() + static_cast<std::ptrdiff_t>(row * n_columns_);
  std::fill(row_begin + column_of(x_low - radius_m - slack),
            row_begin + column_of(x_high + radius_m + slack) + 1, std::uint8_t{1});
}

}  // namespace ridgeline::io
