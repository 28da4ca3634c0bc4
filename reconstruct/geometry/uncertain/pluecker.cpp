// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/pluecker.h"

#include <Eigen/Geometry>

namespace ridgeline {

Eigen::Matrix<double, 6, 4> pi_matrix(const Eigen::Vector4d& x) {
  Eigen::Matrix<double, 6, 4> pi;
  pi << x.w() * Eigen::Matrix3d::Identity(), -x.head<3>(), skew(x.head<3>()),
      Eigen::Vector3d::Zero();
  return pi;
}

Eigen::Matrix<double, 6, 4> pi_bar_matrix(const Eigen::Vector4d& x) {
  Eigen::Matrix<double, 6, 4> pi_bar;
  pi_bar << skew(x.head<3>()), Eigen::Vector3d::Zero(), x.w() * Eigen::Matrix3d::Identity(),
      -x.head<3>();
  return pi_bar;
}

Eigen::Matrix4d gamma_matrix(const Vector6d& line) {
  Eigen::Matrix4d gamma;
  gamma << -skew(line.tail<3>()), -line.head<3>(), line.head<3>().transpose(), 0.0;
  return gamma;
}

Eigen::Matrix4d gamma_bar_matrix(const Vector6d& line) { return gamma_matrix(dual(line)); }

Vector6d dual(const Vector6d& line) {
  Vector6d swapped;
  swapped << line.tail<3>(), line.head<3>();
  return swapped;
}

Eigen::Matrix<double, 3, 6> line_projection(const ProjectionMatrix& image_from_object) {
  const Eigen::Matrix<double, 4, 3> p = image_from_object.transpose();
  Eigen::Matrix<double, 6, 3> q;
  q << pi_matrix(p.col(1)) * p.col(2), pi_matrix(p.col(2)) * p.col(0),
      pi_matrix(p.col(0)) * p.col(1);
  return q.transpose();
}

int dominant_component(const Vector6d& line) {
  Eigen::Index index = 0;
  line.cwiseAbs().maxCoeff(&index);
  return static_cast<int>(index);
}

RowPair point_on_line_rows(int dominant) {
  static constexpr std::array<RowPair, 6> kRows{{{1, 2}, {2, 0}, {0, 1}, {0, 3}, {1, 3}, {2, 3}}};
  return kRows.at(static_cast<std::size_t>(dominant));
}

RowPair line_in_plane_rows(int dominant) {
  return point_on_line_rows((dominant + 3) % 6);  // a plane is the dual of a point
}

Vector6d project_to_pluecker_quadric(const Vector6d& line) {
  // In u and w the quadric is |u| = |w|, since L_h . L_0 = (|u|^2 - |w|^2) / 4.
  const Eigen::Vector3d u = line.head<3>() + line.tail<3>();
  const Eigen::Vector3d w = line.head<3>() - line.tail<3>();
  Vector6d projected;
  projected << u / u.norm() + w / w.norm(), u / u.norm() - w / w.norm();
  return projected.normalized();
}

Eigen::Matrix<double, 6, 4> line_tangent_basis(const Vector6d& line) {
  Eigen::Matrix<double, 6, 2> normals;
  normals << dual(line), line;
  return orthogonal_factor<6, 2>(normals).rightCols<4>();
}

double signed_distance(const Vector6d& a, const Vector6d& b) {
  return a.dot(dual(b)) / a.head<3>().cross(b.head<3>()).norm();
}

UncertainPlane3 projection_plane(const ProjectionMatrix& image_from_object,
                                 const UncertainLine2& line) {
  return {image_from_object.transpose() * line.mean,
          image_from_object.transpose() * line.cov * image_from_object};
}

UncertainPlane3 projection_plane(const ProjectionMatrix& image_from_object,
                                 const Eigen::Matrix<double, 12, 12>& cov_vec_p,
                                 const UncertainLine2& line) {
  Eigen::Matrix<double, 4, 12> jacobian = Eigen::Matrix<double, 4, 12>::Zero();
  for (Eigen::Index column = 0; column < 4; ++column) {
    jacobian.block<1, 3>(column, 3 * column) = line.mean.transpose();
  }
  UncertainPlane3 plane = projection_plane(image_from_object, line);
  plane.cov += propagated(jacobian, cov_vec_p);
  return plane;
}

std::optional<UncertainLine3> intersection(const UncertainPlane3& a, const UncertainPlane3& b) {
  constexpr double kMinSine = 1e-9;  // below this, the direction is only rounding error
  const Eigen::Vector3d normal_a = a.mean.head<3>();
  const Eigen::Vector3d normal_b = b.mean.head<3>();
  // The condition is negated so that a plane without a normal (at infinity, or NaN) has no
  // intersection either.
  if (!(normal_a.cross(normal_b).norm() > kMinSine * normal_a.norm() * normal_b.norm())) {
    return std::nullopt;
  }
  const Eigen::Matrix<double, 6, 4> pi_a = pi_bar_matrix(a.mean);
  const Eigen::Matrix<double, 6, 4> pi_b = pi_bar_matrix(b.mean);
  return spherically_normalised(
      UncertainLine3{pi_a * b.mean, propagated(pi_a, b.cov) + propagated(pi_b, a.cov)});
}

}  // namespace ridgeline
