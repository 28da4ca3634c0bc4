// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/estimate/line_geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// The plane through the image line that is normal to the segment at `x`. Only the position of x along the
/// segment makes it uncertain.
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
  Eigen::Matrix<double, 3, 6> jacobian;  ///< derivative of the Euclidean point by the line
  Eigen::Matrix3d cov_along;             ///< the covariance's share of the image endpoint
};

/// The endpoint X = Gamma(L) B with dX/dL = -Pi'(B), dX/dB = Gamma(L).
Endpoint endpoint(const UncertainLine3& line, const UncertainPlane3& plane) {
  const Eigen::Matrix4d gamma = gamma_matrix(line.mean);
  const Eigen::Vector4d point = gamma * plane.mean;
  const Eigen::Matrix<double, 3, 4> euclidean = euclidean_jacobian(point);
  const Eigen::Matrix<double, 3, 4> by_plane = euclidean * gamma;
  return {point, -euclidean * pi_matrix(plane.mean).transpose(), propagated(by_plane, plane.cov)};
}

Segment3 local_from_conditioned(const ObjectConditioning& object, const Segment3& s) {
  return {object.local_from_conditioned(s.start), object.local_from_conditioned(s.end)};
}

/// Whether the ends of the left segment lie so far beyond a short right one that the line is no longer known
/// there, while it is better known between the right ends.
bool is_extrapolated(const UncertainSegment3& left,
                     const UncertainSegment3& right,
                     double scale_m,
                     double max_end_sigma_m) {
  const double sigma_m = scale_m * largest_sigma_z_m(left.cov);
  return sigma_m > max_end_sigma_m && scale_m * largest_sigma_z_m(right.cov) < sigma_m;
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
  Matrix6d cov = propagated(jacobian, line.cov);
  cov.topLeftCorner<3, 3>() += start.cov_along;
  cov.bottomRightCorner<3, 3>() += end.cov_along;
  return UncertainSegment3{{start.point.hnormalized(), end.point.hnormalized()}, cov};
}

double largest_sigma_z_m(const Matrix6d& cov_m2) {
  return std::sqrt(std::max(cov_m2(2, 2), cov_m2(5, 5)));
}

bool assign_geometry(const StereoViews& stereo,
                     const ObservedPair& seen,
                     const UncertainLine3& estimate,
                     double max_end_sigma_m,
                     ReconstructedLine& result) {
  const std::array<ConditionedView, 2>& views = stereo.views;
  const auto left = endpoints(estimate, views[0], seen[0], views);
  if (!left) return false;
  const auto right = endpoints(estimate, views[1], seen[1], views);
  const ObjectConditioning& object = stereo.object;
  result.between_right_ends = right && result.line_class == LineClass::kNotAligned &&
                              (result.between_right_ends ||
                               is_extrapolated(*left, *right, object.scale_m, max_end_sigma_m));
  const UncertainSegment3& used = result.between_right_ends ? *right : *left;
  result.segment_in_local = local_from_conditioned(object, used.segment);
  result.covariance_m2 = object.scale_m * object.scale_m * used.cov;
  result.right_segment_in_local.reset();
  if (right) result.right_segment_in_local = local_from_conditioned(object, right->segment);
  return true;
}

}  // namespace ridgeline::reconstruct
