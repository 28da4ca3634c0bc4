// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/plane_difference.h"

#include "evaluate/faces/limits.h"
#include "evaluate/probability.h"
#include "reconstruct/geometry/degrees.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

constexpr double kLevel_rad = 5.0 * kRadPerDeg;  // as in roof_kind.cpp
constexpr int kParameters = 3;                   // of a plane

/// Horizontal unit vector to the left of a plane's slope, and unit vector up its slope, in the
/// plane.
struct SlopeAxes {
  Eigen::Vector3d left, up;
};

SlopeAxes slope_axes(const Plane3& plane) {
  constexpr double kLevel = 1e-9;  // a smaller tilt is due to rounding
  const Eigen::Vector3d& n = plane.normal();
  const Eigen::Vector2d fall = n.head<2>();
  const Eigen::Vector2d rise =
      fall.norm() > kLevel ? Eigen::Vector2d(-fall.normalized()) : Eigen::Vector2d::UnitY();
  const Eigen::Vector3d left(-rise.y(), rise.x(), 0.0);
  return {left, left.cross(n)};
}

/// The covariance of a fitted plane's normal, whose error lies within the plane.
Eigen::Matrix2d normal_covariance(const PlaneFit& fit) {
  const double variance_m2 = fit.sigma0_m * fit.sigma0_m;
  return (variance_m2 * fit.spread_m2.cwiseInverse()).asDiagonal();
}

/// Half widths of 95 % intervals.
class HalfWidth {
 public:
  explicit HalfWidth(const PlaneFit& fit)
      : fit_(fit), quantile_(student_t_quantile(fit.n - kParameters, 0.975)) {}

  /// Of the plane's distance at a point on it, along its normal.
  [[nodiscard]] double at(const Eigen::Vector3d& x) const { return quantile_ * fit_.sigma_at(x); }
  /// Of a value that changes by gradient . dn with the plane's normal n.
  [[nodiscard]] double of_normal(const Eigen::Vector3d& gradient) const {
    const Eigen::Vector2d in_plane = fit_.axes.transpose() * gradient;
    return quantile_ * std::sqrt(in_plane.dot(normal_covariance(fit_) * in_plane));
  }

 private:
  const PlaneFit& fit_;
  double quantile_;
};

/// The angle from the face's normal to the fitted one towards `axis`, which is perpendicular to the
/// face's normal.
Estimate part_of_angle(const RoofFace& face,
                       const PlaneFit& fit,
                       const Eigen::Vector3d& axis,
                       const HalfWidth& half_width) {
  const Eigen::Vector3d& own = face.plane.normal();
  const Eigen::Vector3d& n = fit.plane.normal();
  const double a = n.dot(axis), b = n.dot(own);
  const Eigen::Vector3d gradient = (b * axis - a * own) / (a * a + b * b);
  return {std::atan2(a, b) / kRadPerDeg, half_width.of_normal(gradient) / kRadPerDeg};
}

Estimate angle_between(const RoofFace& face, const PlaneFit& fit, const HalfWidth& half_width) {
  const Eigen::Vector3d& own = face.plane.normal();
  const Eigen::Vector3d& n = fit.plane.normal();
  constexpr double kExact = 1e-15;
  const Eigen::Vector3d towards_own = own - own.dot(n) * n;  // of length sin(angle)
  const double sine = towards_own.norm();  // for equal planes the direction is only rounding
  const Eigen::Vector3d gradient = towards_own / std::max(sine, kExact);
  return {std::atan2(sine, own.dot(n)) / kRadPerDeg, half_width.of_normal(gradient) / kRadPerDeg};
}

double wrapped_deg(double angle_deg) { return std::remainder(angle_deg, 360.0); }

/// Downslope direction of a plane, clockwise from y.
double aspect_deg(const Plane3& plane) {
  return std::atan2(plane.normal().x(), plane.normal().y()) / kRadPerDeg;
}

void set_slopes(const RoofFace& face,
                const PlaneFit& fit,
                const HalfWidth& half_width,
                PlaneDifference& difference) {
  const double own_rad = slope_rad(face.plane), fitted_rad = slope_rad(fit.plane);
  const SlopeAxes axes = slope_axes(fit.plane);
  if (std::max(own_rad, fitted_rad) >= kLevel_rad) {
    difference.pitch_deg = {(own_rad - fitted_rad) / kRadPerDeg,
                            half_width.of_normal(axes.up) / kRadPerDeg};
  }
  if (std::min(own_rad, fitted_rad) >= kLevel_rad) {
    difference.aspect_deg = {wrapped_deg(aspect_deg(face.plane) - aspect_deg(fit.plane)),
                             half_width.of_normal(axes.left / std::sin(fitted_rad)) / kRadPerDeg};
  }
}

bool exceeds(const Estimate& estimate, double tolerance) {
  return std::abs(estimate.value) - estimate.half_width > tolerance;
}

/// The smallest distance of the face's vertices above the plane of its points, or below it for a
/// negative `sign`.
double smallest_shift_m(const RoofFace& face, const PlaneFit& fit, double sign) {
  double smallest_m = HUGE_VAL;
  for (const Eigen::Vector3d& vertex : face.rings.front()) {
    const Eigen::Vector3d x = face.plane.projection(vertex);
    smallest_m = std::min(smallest_m, sign * fit.plane.signedDistance(x));
  }
  return smallest_m;
}

}  // namespace

PlaneDifference difference_of(const RoofFace& face, const PlaneFit& fit) {
  const HalfWidth half_width(fit);
  const Eigen::Vector3d& own = face.plane.normal();
  const Eigen::Vector3d& n = fit.plane.normal();
  const double distance_m = fit.plane.signedDistance(face.centroid);
  const auto estimate_along = [&](const Eigen::Vector3d& way) -> Estimate {
    const double value = distance_m / n.dot(way);
    const Eigen::Vector3d foot = face.centroid - value * way;
    return {value, half_width.at(foot) / n.dot(way)};
  };
  const SlopeAxes axes = slope_axes(face.plane);
  PlaneDifference difference;
  difference.shift_m = estimate_along(own);
  difference.height_m = estimate_along(Eigen::Vector3d::UnitZ());
  difference.angle_deg = angle_between(face, fit, half_width);
  difference.along_deg = part_of_angle(face, fit, axes.up, half_width);
  difference.across_deg = part_of_angle(face, fit, axes.left, half_width);
  set_slopes(face, fit, half_width, difference);
  return difference;
}

FaceVerdict plane_verdict(const RoofFace& face,
                          const PlaneFit& fit,
                          const PlaneDifference& difference) {
  FaceVerdict verdict;
  verdict.tilt = exceeds(difference.angle_deg, kTiltTolerance_deg);
  verdict.height = exceeds(difference.shift_m, kHeightTolerance_m);
  if (verdict.tilt && verdict.height) {
    const double sign = difference.shift_m.value > 0.0 ? 1.0 : -1.0;
    verdict.height = smallest_shift_m(face, fit, sign) > kHeightTolerance_m;
  }
  return verdict;
}

}  // namespace ridgeline::evaluate
