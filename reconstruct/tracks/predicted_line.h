// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"
#include "reconstruct/tracks/searched_views.h"

#include <Eigen/Core>

#include <array>
#include <span>

namespace ridgeline::reconstruct {

/// A line in the plane of a segment: the heights of the points that the view shows at the segment's
/// ends.
struct SegmentDepth {
  Eigen::Vector2d heights_m;
  Eigen::Matrix2d cov_m2;
};

/// Where a view shows the line of a segment of another view.
struct PredictedLine {
  Segment2 segment;
  std::array<Eigen::Vector2d, 2> per_height;  ///< shift of the ends by height, px/m
};

PredictedLine predict(const EndStretches& ends, const Eigen::Vector2d& heights_m);

/// The interval of a segment's line that another segment covers, as parameters from its start (0)
/// to its end (1).
std::array<double, 2> span_on(const Segment2& line, const Segment2& other);

/// How far a prediction is from a segment across it, at two places of the prediction.
struct PredictionResidual {
  Eigen::Vector2d heights_m;  ///< of the prediction
  Eigen::Vector2d residual_px;
  Eigen::Matrix2d by_heights;
  Eigen::Matrix2d cov_px2;  ///< of both segments, without that of the heights

  [[nodiscard]] Eigen::Matrix2d cov_with(const SegmentDepth& depth) const {
    return cov_px2 + by_heights * depth.cov_m2 * by_heights.transpose();
  }
};

double chi_square(const PredictionResidual& o, const Eigen::Matrix2d& cov_px2);

/// @param own            the segment whose line is predicted
/// @param at             two places as parameters of the prediction
/// @param sigma_edge_px  of each place, beside those of the two segments
PredictionResidual residual_of(const UncertainSegment2& own,
                               const Eigen::Vector2d& heights_m,
                               const PredictedLine& p,
                               const UncertainSegment2& seen,
                               const std::array<double, 2>& at,
                               double sigma_edge_px);

/// The heights that observations give together, by least squares. They are not finite if the
/// observations do not tell them.
SegmentDepth depth_by(std::span<const PredictionResidual> residuals);

}  // namespace ridgeline::reconstruct
