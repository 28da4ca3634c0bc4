// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"
#include "reconstruct/tracks/searched_views.h"

#include <Eigen/Core>

#include <array>
#include <span>

namespace ridgeline::reconstruct {

/// A line in the projection plane of a segment, given by the heights of its points at the segment's
/// ends.
struct SegmentDepth {
  Eigen::Vector2d heights_m;
  Eigen::Matrix2d cov_m2;
};

/// The predicted image in a view of the line of a segment of another view.
struct PredictedLine {
  Segment2 segment;
  std::array<Eigen::Vector2d, 2> per_height;  ///< shift of the ends per metre of height, px/m
};

PredictedLine predict(const EndStretches& ends, const Eigen::Vector2d& heights_m);

/// The interval of a segment's line that is covered by another segment, as parameters from the
/// start (0) to the end (1) of the former.
std::array<double, 2> span_on(const Segment2& line, const Segment2& other);

/// The offset of a prediction from a segment, across the segment, at two points of the prediction.
struct PredictionResidual {
  Eigen::Vector2d heights_m;  ///< of the prediction
  Eigen::Vector2d residual_px;
  Eigen::Matrix2d by_heights;
  Eigen::Matrix2d cov_px2;  ///< of both segments, without the contribution of the heights

  [[nodiscard]] Eigen::Matrix2d cov_with(const SegmentDepth& depth) const {
    return cov_px2 + by_heights * depth.cov_m2 * by_heights.transpose();
  }
};

double chi_square(const PredictionResidual& o, const Eigen::Matrix2d& cov_px2);

/// @param own            the segment whose line is predicted
/// @param at             the two points, as parameters of the prediction
/// @param sigma_edge_px  sigma of each point, in addition to the sigmas of the two segments
PredictionResidual residual_of(const UncertainSegment2& own,
                               const Eigen::Vector2d& heights_m,
                               const PredictedLine& p,
                               const UncertainSegment2& seen,
                               const std::array<double, 2>& at,
                               double sigma_edge_px);

/// The heights determined jointly by the observations, by least squares. They are not finite if the
/// observations do not determine them.
SegmentDepth depth_by(std::span<const PredictionResidual> residuals);

}  // namespace ridgeline::reconstruct
