// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/footprint.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The corners of the convex hull, counter-clockwise, starting at the smallest x. For collinear
/// points these are the two end points, for a single point the point itself; empty for no points.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// Convex hull of points in the footprint's axes (s, t).
class PlanHull {
 public:
  explicit PlanHull(std::span<const ZonePoint> points);

  /// Whether the point lies inside the hull or on its border; a hull without area contains nothing.
  [[nodiscard]] bool contains(const Eigen::Vector2d& st) const;
  /// Distance of the point from the hull; 0 inside, infinite for the hull of no points.
  [[nodiscard]] double distance_to(const Eigen::Vector2d& st) const;

 private:
  std::vector<Eigen::Vector2d> corners_;  ///< counter-clockwise
};

}  // namespace ridgeline::evaluate
