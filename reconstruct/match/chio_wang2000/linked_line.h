// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/geometry/uncertain/pluecker.h"
#include "reconstruct/scene/scene.h"

#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// A 3D line through points.
struct FittedLine {
  Segment3 segment;  ///< between the perpendicular feet of the outermost points, in point order
  Matrix6d cov_m2;  ///< covariance of (start, end): across the line from the scatter, zero along it
};

/// Orthogonal regression: the line through the centroid along the axis of largest variance, which
/// minimises the sum of squared distances (Pearson 1901). Its covariance is the scatter across it,
/// a 2x2 covariance, divided by the number of independent points; n points count as n / correlation
/// independent ones. Empty for fewer than three points or if all coincide.
std::optional<FittedLine> fit_line(std::span<const Eigen::Vector3d> points, double correlation);

/// The 3D line that fit_line() fits to the reliable points of the chains of a left segment with
/// right ones. The uncertainty of the first right line is added to its covariance, because it is
/// common to all points of a link: it moves them along their rays and tilts their line. Empty for
/// fewer than three reliable points.
std::optional<FittedLine> line_through_links(int left_id,
                                             std::span<const int> right_ids,
                                             const SearchedPair& pair,
                                             double gsd_m);

}  // namespace ridgeline::reconstruct
