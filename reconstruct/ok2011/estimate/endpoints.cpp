// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/estimate/endpoints.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

/// Plane through the image line normal to the segment at `x`; uncertain by the position of x along
/// the segment only.
UncertainPlane3 end_plane(const ConditionedView& view,
                          const ObservedLine& observed,
                          const Eigen::Vector2d& x) {
  const Eigen::Vector2d u = along(observed.segment);
  UncertainLine2 across{Eigen::Vector3d(u.x(), u.y(), -u.dot(x)), Eigen::Matrix3d::Zero()};
  across.cov(2, 2) = observed.sigma_e * observed.sigma_e;
  return projection_plane(view.image_from_object, across);
}

struct Endpoint {
  Eigen::Vector4d point;
  Eigen::Matrix<double, 3, 6> jacobian;  ///< of the Euclidean point by the line
  Eigen::Matrix3d cov_along;             ///< share of the image endpoint
};

/// X = Gamma(L) B, dX/dL = -Pi'(B), dX/dB = Gamma(L).
Endpoint endpoint(const UncertainLine3& line, const UncertainPlane3& plane) {
  const Eigen::Matrix4d gamma = gamma_matrix(line.mean);
  const Eigen::Vector4d point = gamma * plane.mean;
  const Eigen::Matrix<double, 3, 4> euclidean = euclidean_jacobian(point);
  const Eigen::Matrix<double, 3, 4> by_plane = euclidean * gamma;
  return {point, -euclidean * pi_matrix(plane.mean).transpose(),
          by_plane * plane.cov * by_plane.transpose()};
}

}  // namespace

std::optional<UncertainSegment3> endpoints(const UncertainLine3& line,
                                           const ConditionedView& view,
                                           const ObservedLine& observed,
                                           std::span<const ConditionedView> views) {
  const Endpoint start = endpoint(line, end_plane(view, observed, observed.segment.start));
  const Endpoint end = endpoint(line, end_plane(view, observed, observed.segment.end));
  const bool visible = std::all_of(views.begin(), views.end(), [&](const ConditionedView& v) {
    return in_front(v, start.point) && in_front(v, end.point);
  });
  if (!visible) return std::nullopt;  // a point at infinity is not in front either

  Matrix6d jacobian;
  jacobian << start.jacobian, end.jacobian;
  Matrix6d cov = jacobian * line.cov * jacobian.transpose();
  cov.topLeftCorner<3, 3>() += start.cov_along;
  cov.bottomRightCorner<3, 3>() += end.cov_along;
  return UncertainSegment3{{start.point.hnormalized(), end.point.hnormalized()}, cov};
}

}  // namespace ridgeline::reconstruct
