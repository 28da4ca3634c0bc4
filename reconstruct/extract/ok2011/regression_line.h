// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The line that minimises the perpendicular distances of points.
struct RegressionLine {
  Eigen::Vector2d centroid;
  Eigen::Vector2d along;  ///< unit, from the first to the last point
  /// Residual of every point, n . (x - centroid), n = (-u_y, u_x).
  std::vector<double> residual_px;
  std::vector<double> weight;  ///< weight of every point, in [0, 1]
  double sum_weights = 0.0;
  double sum_weights_t2 = 0.0;     ///< sum of w t^2, t along the line from the centroid
  double rms_px = 0.0;             ///< root mean square of the weighted residuals
  double first = 0.0, last = 0.0;  ///< t of the first and the last point
};

/// Orthogonal regression with the weights of Huber (1.345 sigma, sigma from the median of the
/// residuals). The outermost points at each end have zero weight if there are enough others,
/// because an edge bends inwards next to a corner. At least three points are required, which must
/// not all be identical.
RegressionLine regression_line(std::span<const Eigen::Vector2d> points);

/// Variance of a point across the line, from the residuals. n points count as n / correlation
/// independent ones.
double variance_px2(const RegressionLine& line, double correlation);

/// Noise statistics common to the segments of one image.
struct EdgeNoise {
  double variance_px2 = 0.01;  ///< typical variance of a point across its line
  double correlation = 2.8;    ///< n points count as n / correlation independent ones
};

/// The noise estimated from the lines with at least 30 points. Without such lines, the default
/// values, typical of aerial images, are returned.
EdgeNoise edge_noise(std::span<const RegressionLine> lines);

/// Errors that are common to all lines of an image and not visible in the residuals.
struct SystematicError {
  double across_px = 0.0;  ///< sigma at the centroid
  double ends_px = 0.0;    ///< sigma of an end across the line, relative to the centroid
};

/// The segment between the outermost points, with its uncertainty. The variance of a point comes
/// from the line's own residuals, shrunk towards the typical variance as if ten additional
/// independent points had that variance.
UncertainSegment2 uncertain_segment(const RegressionLine& line,
                                    const EdgeNoise& noise,
                                    const SystematicError& systematic);

}  // namespace ridgeline::reconstruct
