// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace ridgeline {
namespace {

/// A segment in conditioned coordinates; sigma_q and sigma_e are conditioned lengths as well.
struct LineFrame {
  Eigen::Vector2d start, end, centroid;
  Eigen::Vector2d along;  ///< unit, from start to end
  double sigma_q, sigma_phi_rad, sigma_e;
};

LineFrame line_frame(const UncertainSegment2& s, const ImageConditioning& image) {
  const Eigen::Vector2d direction = s.segment.end - s.segment.start;
  return {.start = image.conditioned_from_image(s.segment.start),
          .end = image.conditioned_from_image(s.segment.end),
          .centroid = image.conditioned_from_image(s.centroid_px),
          .along = direction.normalized(),
          .sigma_q = s.sigma_q_px / image.scale_px,
          .sigma_phi_rad = s.sigma_phi_rad,
          .sigma_e = s.sigma_e_px / image.scale_px};
}

/// The line l = (n, -n.c) with dl/dphi = (-u, u.c) and dl/dq = (0, 0, -1).
UncertainLine2 centroid_line(const LineFrame& s) {
  const Eigen::Vector2d& u = s.along;
  const Eigen::Vector2d normal(-u.y(), u.x());
  Eigen::Matrix<double, 3, 2> jacobian;
  jacobian << -u, Eigen::Vector2d::Zero(), u.dot(s.centroid), -1.0;
  const Eigen::Vector2d variances(s.sigma_phi_rad * s.sigma_phi_rad, s.sigma_q * s.sigma_q);
  Eigen::Vector3d line;
  line << normal, -normal.dot(s.centroid);
  return {line, jacobian * variances.asDiagonal() * jacobian.transpose()};
}

/// An endpoint. Its variance along the line is sigma_e^2; across the line, it is the variance of
/// the line at this point.
UncertainPoint2 endpoint(const LineFrame& s, const Eigen::Vector2d& x) {
  const double distance = s.along.dot(x - s.centroid);
  const double across = s.sigma_q * s.sigma_q + std::pow(distance * s.sigma_phi_rad, 2);
  Eigen::Matrix2d axes;
  axes << s.along.x(), -s.along.y(), s.along.y(), s.along.x();
  UncertainPoint2 point{x.homogeneous(), Eigen::Matrix3d::Zero()};
  point.cov.topLeftCorner<2, 2>() =
      axes * Eigen::Vector2d(s.sigma_e * s.sigma_e, across).asDiagonal() * axes.transpose();
  return point;
}

}  // namespace

UncertainSegment2 line_of_ends(const Segment2& ends, double sigma_px) {
  constexpr double kSigmaAlong_px = 1.0;  // the same as for extracted segments
  // With errors a and b of the ends, q = (a + b) / 2 and phi = (b - a) / length are uncorrelated.
  return {.segment = ends,
          .centroid_px = midpoint(ends),
          .sigma_q_px = sigma_px / std::numbers::sqrt2,
          .sigma_phi_rad = sigma_px * std::numbers::sqrt2 / length(ends),
          .sigma_e_px = kSigmaAlong_px};
}

UncertainLine2 uncertain_line(const UncertainSegment2& segment,
                              LineCovariance form,
                              const ImageConditioning& image) {
  const double length_px = length(segment.segment);
  check(length_px > 0.0 && std::isfinite(length_px), "uncertain_line: length = ", length_px,
        " px, must be positive");
  check(segment.sigma_q_px > 0.0, "uncertain_line: sigma_q_px = ", segment.sigma_q_px,
        ", must be positive");
  check(segment.sigma_phi_rad > 0.0, "uncertain_line: sigma_phi_rad = ", segment.sigma_phi_rad,
        ", must be positive");
  const LineFrame frame = line_frame(segment, image);
  return spherically_normalised(
      form == LineCovariance::kCentroid
          ? centroid_line(frame)
          : cross(endpoint(frame, frame.start), endpoint(frame, frame.end)));
}

}  // namespace ridgeline
