// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <span>

namespace ridgeline::evaluate {

/// Points next to a straight border, in a frame along it: x = s along, y = t outwards.
struct BorderPoints {
  std::span<const Eigen::Vector2d> st_m;
  double length_m;  ///< the border extends over 0 <= s <= length_m
  double sigma_m;   ///< of a point in the plane, per axis
  /// A slope dt/ds that borders of such planes usually have, and its standard deviation; infinite
  /// if there is none.
  double usual_slope, usual_slope_sigma;
};

/// t = offset_m + slope (s - length_m / 2).
struct BorderLine {
  double offset_m = 0.0, slope = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of (offset_m, slope)
  double moved_out_m = 0.0;  ///< mean distance from the outermost points
};

/// The border of an area that points cover evenly: the mean of the posterior of a line behind which
/// points have the density observed next to it, blurred by sigma_m, and beyond which there are none
/// but one in a hundred. It has the least mean squared error of all estimates that move with the
/// points (Pitman 1939); the outermost points themselves lie inside the border by the mean gap.
/// At least three points are needed.
BorderLine border_line(const BorderPoints& points);

}  // namespace ridgeline::evaluate
