// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/options.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A run of points [first, last).
struct Piece {
  int first = 0, last = 0;
};

/// The centroid and principal axes of a set of points.
struct PrincipalAxes {
  Eigen::Vector2d centroid;
  /// Unit vector of the axis of larger variance, directed from the first to the last point.
  Eigen::Vector2d along;
  double lambda_min = 0.0;    ///< variance across the axis, dividing by n
  double max_distance = 0.0;  ///< maximum distance of a point from the axis
};
/// Requires at least one point; for identical points, the axis is the x axis.
PrincipalAxes principal_axes(std::span<const Eigen::Vector2d> points);

/// Straightness: maximum variance across the line. Ours; Ok et al. 2011, section 2, give no value.
inline constexpr double kMaxLambdaMinPx2 = 0.15;

/// Cuts an ordered curve into straight pieces: a run is straight if the points' variance across
/// their principal axis is at most kMaxLambdaMinPx2 and no point is farther from it than
/// `max_deviation_px`; otherwise it is cut at the point farthest from the chord between its ends,
/// and both parts are treated in the same way. Pieces whose chord is shorter than `min_length_px`
/// are left out.
std::vector<Piece> straight_pieces(std::span<const Eigen::Vector2d> points,
                                   const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
