// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/QR>

namespace ridgeline {

/// A vector with the covariance of its components. The covariance of a homogeneous vector is
/// singular (its scale is no random quantity) and is never inverted as such: see tangent_basis().
template <int N>
struct Uncertain {
  Eigen::Matrix<double, N, 1> mean;
  Eigen::Matrix<double, N, N> cov;
};

using UncertainPoint2 = Uncertain<3>;  ///< image point, homogeneous
using UncertainLine2 = Uncertain<3>;   ///< image line (n, -n.x): l.x = 0
using UncertainPoint3 = Uncertain<4>;  ///< (X_0; X_h), Euclidean part first
using UncertainPlane3 = Uncertain<4>;  ///< (A_h; A_0), normal first: A.X = 0
using UncertainLine3 = Uncertain<6>;   ///< Pluecker (L_h; L_0), direction first

/// S(a) b = a x b.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  return (Eigen::Matrix3d() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0).finished();
}

/// Orthonormal basis of the complement of x: the coordinates in which a homogeneous vector has a
/// regular covariance, B' cov B. N x (N-1).
template <int N>
Eigen::Matrix<double, N, N - 1> tangent_basis(const Eigen::Matrix<double, N, 1>& x) {
  const Eigen::HouseholderQR<Eigen::Matrix<double, N, 1>> qr(x);
  const Eigen::Matrix<double, N, N> q = qr.householderQ();
  return q.template rightCols<N - 1>();
}

/// x / |x| with the covariance J cov J', J = (I - x_s x_s') / |x|: the covariance loses the part
/// along x, which says nothing of the entity.
template <int N>
Uncertain<N> spherically_normalised(const Uncertain<N>& x) {
  const double norm = x.mean.norm();
  const Eigen::Matrix<double, N, 1> unit = x.mean / norm;
  const Eigen::Matrix<double, N, N> jacobian =
      (Eigen::Matrix<double, N, N>::Identity() - unit * unit.transpose()) / norm;
  return {unit, jacobian * x.cov * jacobian.transpose()};
}

/// a x b of uncorrelated a and b: the join of two image points (Ok et al. 2011, Eq. 1) or the
/// intersection of two image lines (Eq. 2). Not normalised; zero if both are the same entity.
inline Uncertain<3> cross(const Uncertain<3>& a, const Uncertain<3>& b) {
  const Eigen::Matrix3d sa = skew(a.mean);
  const Eigen::Matrix3d sb = skew(b.mean);
  return {a.mean.cross(b.mean), sa * b.cov * sa.transpose() + sb * a.cov * sb.transpose()};
}

/// d(X_0 / X_h) / dX at a point that is not at infinity.
inline Eigen::Matrix<double, 3, 4> euclidean_jacobian(const Eigen::Vector4d& x) {
  Eigen::Matrix<double, 3, 4> jacobian;
  jacobian << Eigen::Matrix3d::Identity(), -x.hnormalized();
  return jacobian / x.w();
}

}  // namespace ridgeline
