// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/predicted_line.h"

#include <Eigen/LU>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

double square(double x) { return x * x; }

/// Covariance, across a regression line, of two of its points, given by their distances along the
/// line from the centroid.
Eigen::Matrix2d across(const UncertainSegment2& s, const Eigen::Vector2d& from_centroid_px) {
  return square(s.sigma_q_px) * Eigen::Matrix2d::Ones() +
         square(s.sigma_phi_rad) * from_centroid_px * from_centroid_px.transpose();
}

}  // namespace

PredictedLine predict(const EndStretches& ends, const Eigen::Vector2d& heights_m) {
  return {{ends[0].at(heights_m[0]), ends[1].at(heights_m[1])},
          {ends[0].derivative(heights_m[0]), ends[1].derivative(heights_m[1])}};
}

std::array<double, 2> span_on(const Segment2& line, const Segment2& other) {
  const double a = parameter_along(line, other.start);
  const double b = parameter_along(line, other.end);
  return {std::min(a, b), std::max(a, b)};
}

double chi_square(const PredictionResidual& o, const Eigen::Matrix2d& cov_px2) {
  return o.residual_px.dot(cov_px2.inverse() * o.residual_px);
}

PredictionResidual residual_of(const UncertainSegment2& own,
                               const Eigen::Vector2d& heights_m,
                               const PredictedLine& p,
                               const UncertainSegment2& seen,
                               const std::array<double, 2>& at,
                               double sigma_edge_px) {
  const Eigen::Vector2d n = normal(seen.segment);
  const Eigen::Vector2d u = along(seen.segment);
  const double own_length_px = length(own.segment);
  const double own_centroid = parameter_along(own.segment, own.centroid_px);
  PredictionResidual o;
  o.heights_m = heights_m;
  Eigen::Vector2d on_seen;
  Eigen::Vector2d on_own;
  for (const int i : {0, 1}) {
    const double t = at[static_cast<std::size_t>(i)];
    const Eigen::Vector2d x = point_at(p.segment, t);
    o.residual_px[i] = n.dot(x - seen.segment.start);
    o.by_heights(i, 0) = (1.0 - t) * n.dot(p.per_height[0]);
    o.by_heights(i, 1) = t * n.dot(p.per_height[1]);
    on_seen[i] = u.dot(x - seen.centroid_px);
    on_own[i] = (t - own_centroid) * own_length_px;
  }
  o.cov_px2 = across(seen, on_seen) + across(own, on_own) +
              square(sigma_edge_px) * Eigen::Matrix2d::Identity();
  return o;
}

SegmentDepth depth_by(std::span<const PredictionResidual> residuals) {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  for (const PredictionResidual& o : residuals) {
    const Eigen::Matrix2d weight = o.by_heights.transpose() * o.cov_px2.inverse();
    information += weight * o.by_heights;
    weighted += weight * (o.by_heights * o.heights_m - o.residual_px);
  }
  const Eigen::Matrix2d cov_m2 = information.inverse();
  return {cov_m2 * weighted, cov_m2};
}

}  // namespace ridgeline::reconstruct
