// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/conditions.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace ridgeline::reconstruct {

/// The variance of the distance along the line, v(t) = sigma_q^2 + sigma_phi^2 (t - t_c)^2, gives
/// the centroid t_c and both sigmas. The distances at t_c + sigma_q / sigma_phi and t_c - sigma_q /
/// sigma_phi are uncorrelated.
ImageCondition::ImageCondition(const ProjectionMatrix& image_from_object,
                               const UncertainLine2& observed)
    : image_from_line_(line_projection(image_from_object)) {
  const Eigen::Vector2d normal = observed.mean.head<2>();
  const double norm = normal.norm();
  const Eigen::Vector2d along = Eigen::Vector2d(normal.y(), -normal.x()) / norm;
  const Eigen::Vector2d foot = -observed.mean.z() / (norm * norm) * normal;  // foot of the origin
  const auto point = [&](double t) {
    return Eigen::Vector3d(Eigen::Vector2d(foot + t * along).homogeneous());
  };
  const auto variance = [&](double t) {
    return point(t).dot(observed.cov * point(t)) / (norm * norm);
  };
  const double square = 0.5 * (variance(1.0) + variance(-1.0)) - variance(0.0);
  const double linear = 0.5 * (variance(1.0) - variance(-1.0));
  const double centroid = -0.5 * linear / square;
  const double sigma_q = std::sqrt(variance(centroid));
  const double lever = sigma_q / std::sqrt(square);
  points_ = {point(centroid - lever), point(centroid + lever)};
  sigma_ = std::numbers::sqrt2 * sigma_q;
}

std::array<OfLine, 2> ImageCondition::at(const Vector6d& line) const {
  const Eigen::Vector3d image = image_from_line_ * line;
  const double norm = image.head<2>().norm();
  const Eigen::Vector3d normal(image.x() / norm, image.y() / norm, 0.0);
  std::array<OfLine, 2> deviations;
  for (std::size_t i = 0; i < 2; ++i) {
    const double distance = points_[i].dot(image) / norm;
    deviations[i].value = distance / sigma_;
    deviations[i].by_line =
        ((points_[i] - distance * normal).transpose() * image_from_line_ / (norm * sigma_))
            .transpose();
  }
  return deviations;
}

OfLinePair meeting(const Vector6d& first, const Vector6d& second) {
  const Eigen::Vector3d normal = first.head<3>().cross(second.head<3>());
  const double sine = normal.norm();
  const Eigen::Vector3d unit = normal / sine;
  OfLinePair result;
  result.value = first.dot(dual(second)) / sine;
  result.by_first = dual(second) / sine;
  result.by_second = dual(first) / sine;
  // d|a x b| = (b x n).da = (n x a).db for the unit normal n.
  result.by_first.head<3>() -= result.value / sine * Eigen::Vector3d(second.head<3>()).cross(unit);
  result.by_second.head<3>() -= result.value / sine * unit.cross(Eigen::Vector3d(first.head<3>()));
  return result;
}

OfLine rise(const Vector6d& line) {
  const double norm = line.head<3>().norm();
  OfLine result{line(2) / norm, Vector6d::Zero()};
  result.by_line.head<3>() =
      (Eigen::Vector3d::UnitZ() - result.value * line.head<3>() / norm) / norm;
  return result;
}

OfLine height_in_plane(const Vector6d& line, const Eigen::Vector4d& plane) {
  const Eigen::Vector4d x = gamma_matrix(line) * plane;
  const Eigen::Matrix<double, 4, 6> by_line = -pi_matrix(plane).transpose();
  const Eigen::Matrix<double, 3, 6> euclidean = euclidean_jacobian(x) * by_line;
  return {x.hnormalized().z(), euclidean.row(2).transpose()};
}

Eigen::Vector4d end_plane(const ConditionedView& view,
                          const Segment2& segment,
                          const Eigen::Vector2d& x) {
  return plane_across(view.image_from_object, x, along(segment)).normalized();
}

OfLine end_parallax(const Vector6d& line,
                    const Eigen::Vector4d& left_end_plane,
                    const ConditionedView& right_view,
                    const Segment2& right_segment,
                    const Eigen::Vector2d& right_end) {
  const Eigen::Vector2d u = along(right_segment);
  const Eigen::Vector4d x = gamma_matrix(line) * left_end_plane;
  const Eigen::Vector3d seen = right_view.image_from_object * x;
  Eigen::Matrix<double, 2, 3> by_seen;
  by_seen << Eigen::Matrix2d::Identity(), -seen.hnormalized();
  by_seen /= seen.z();
  const Eigen::Matrix<double, 4, 6> by_line = -pi_matrix(left_end_plane).transpose();
  return {u.dot(seen.hnormalized() - right_end),
          (u.transpose() * by_seen * right_view.image_from_object * by_line).transpose()};
}

}  // namespace ridgeline::reconstruct
