// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/point_search.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ridgeline::evaluate {

/// The plan view of a line with its own axes: s along the line from the start, t across, positive
/// to the left. The start is the end with the smaller x (if equal, the smaller y), so that a line
/// given in the opposite direction has the same axes.
struct Footprint {
  Eigen::Vector2d start;
  Eigen::Vector2d along;   ///< unit
  Eigen::Vector2d across;  ///< unit, `along` turned left
  double length_m;

  [[nodiscard]] double s(const Eigen::Vector2d& x) const { return along.dot(x - start); }
  [[nodiscard]] double t(const Eigen::Vector2d& x) const { return across.dot(x - start); }
  [[nodiscard]] Eigen::Vector2d at(double s_m) const { return start + s_m * along; }
  [[nodiscard]] Eigen::Vector2d middle() const { return at(0.5 * length_m); }
};

/// Throws std::invalid_argument for a segment without a direction in plan (vertical or a point).
Footprint footprint_of(const Segment3& segment);

/// A LIDAR point beside a line.
struct ZonePoint {
  Eigen::Vector3d x;
  double s, t;             ///< in the footprint's axes, m
  std::uint32_t index;     ///< in the input cloud
  std::uint32_t rank = 0;  ///< in the zone
};

/// All points with |t| <= half_width and -end <= s <= length + end, at any height: a line whose
/// height is wrong by metres gets the same points. They are sorted by x, then y, then z, so that
/// the same points give the same zone regardless of how they are distributed over files and in
/// which order they are read. Points with identical coordinates, which occur in overlapping tiles,
/// are kept once.
std::vector<ZonePoint> points_beside(const PointSearch& search,
                                     const Footprint& footprint,
                                     double half_width_m,
                                     double end_m);

}  // namespace ridgeline::evaluate
