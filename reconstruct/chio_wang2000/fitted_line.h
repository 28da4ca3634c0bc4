// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/pluecker.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// A 3D line through points.
struct FittedLine {
  Segment3 segment;  ///< between the feet of the outermost points, in the order of the points
  Matrix6d cov_m2;   ///< of (start, end): across the line from the scatter, none along it
};

/// Orthogonal regression: the line through the centroid along the axis of largest variance, which
/// minimises the sum of squared distances (Pearson 1901). The scatter across it, a 2x2 covariance,
/// divided by the number of independent points gives its covariance; n points count as
/// n / correlation independent ones. Empty for fewer than three points or points in one place.
std::optional<FittedLine> fit_line(std::span<const Eigen::Vector3d> points, double correlation);

}  // namespace ridgeline::reconstruct
