// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/footprint.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The corners of the convex hull, counter-clockwise from the least x; of points on one line its two ends,
/// of one point that, of none none.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// Convex hull of points in the footprint's axes (s, t).
class PlanHull {
 public:
  explicit PlanHull(std::span<const ZonePoint> points);

  /// Borders included; a hull without area contains nothing.
  [[nodiscard]] bool contains(const Eigen::Vector2d& st) const;
  /// 0 inside; infinite for a hull of no points.
  [[nodiscard]] double distance_to(const Eigen::Vector2d& st) const;

 private:
  std::vector<Eigen::Vector2d> corners_;  ///< counter-clockwise
};

}  // namespace ridgeline::evaluate
