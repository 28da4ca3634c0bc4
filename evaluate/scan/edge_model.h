// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/border_line.h"
#include "evaluate/scan/scan_edges.h"
#include "evaluate/scan/scan_region.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <array>

namespace ridgeline::evaluate {

/// A straight line in space with its errors across: at the distance s from `middle`, the line lies
/// off by across (a + b s), with the covariance of (a, b).
struct EdgeModel {
  Eigen::Vector3d middle, direction;
  Eigen::Matrix<double, 3, 2> across;  ///< unit vectors, perpendicular to the direction
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< of (a1, a2, b1, b2), m^2, m, 1

  /// Variance across the line at the distance s, mean of both directions.
  [[nodiscard]] double variance_m2(double s) const;
  /// Covariance of the ends of a segment on the line, m^2.
  /// @param along_m2  variance of each end along the line
  [[nodiscard]] Eigen::Matrix<double, 6, 6> covariance_of_ends(
      const Segment3& segment, const std::array<double, 2>& along_m2) const;
};

/// The intersection of two planes, from the covariance of both.
EdgeModel model_of_seam(const Segment3& segment, const PlaneFit& a, const PlaneFit& b);

/// The border of a plane.
/// @param segment  on the border, in the direction of the line's frame
/// @param out  in the plane, unit
EdgeModel model_of_border(const Segment3& segment,
                          const Eigen::Vector3d& out,
                          const PlaneFit& plane,
                          const BorderLine& line);

}  // namespace ridgeline::evaluate
