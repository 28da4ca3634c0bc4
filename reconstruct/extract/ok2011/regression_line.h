// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The line that minimises the distances of points across it.
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
/// residuals). The outermost points on each side have no weight if there are enough others, because
/// an edge bends towards the inside next to a corner. It needs three points that are not all the
/// same.
RegressionLine regression_line(std::span<const Eigen::Vector2d> points);

/// Variance of a point across the line from the residuals. n points count as n / correlation
/// independent ones.
double variance_px2(const RegressionLine& line, double correlation);

/// What the residuals of the segments of one image have in common.
struct EdgeNoise {
  double variance_px2 = 0.01;  ///< typical variance of a point across its line
  double correlation = 2.8;    ///< n points weigh as n / correlation independent ones
};

/// The noise by the lines of at least 30 points. Without such lines, it is typical of aerial
/// images.
EdgeNoise edge_noise(std::span<const RegressionLine> lines);

/// The errors that all lines of an image have in common and that residuals do not show.
struct SystematicError {
  double across_px = 0.0;  ///< sigma at the centroid
  double ends_px = 0.0;    ///< sigma of an end across the line, against the centroid
};

/// The segment between the outermost points with its uncertainty. The variance of a point is that
/// of the line's own residuals, drawn to the typical one as if that came from ten more independent
/// points.
UncertainSegment2 uncertain_segment(const RegressionLine& line,
                                    const EdgeNoise& noise,
                                    const SystematicError& systematic);

}  // namespace ridgeline::reconstruct
