// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

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

/// The matrix S(a) with S(a) b = a x b.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  return (Eigen::Matrix3d() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0).finished();
}

/// Covariance J cov J' of a function of a quantity with covariance cov; J is the function's
/// Jacobian. The templates of this file are compiled in homogeneous.cpp, for the sizes listed
/// there, because Eigen takes seconds for each.
template <int M, int N>
Eigen::Matrix<double, M, M> propagated(const Eigen::Matrix<double, M, N>& jacobian,
                                       const Eigen::Matrix<double, N, N>& cov);

/// Q of the QR decomposition of a matrix, by Householder reflections. Its last columns are an
/// orthonormal basis of what is orthogonal to all columns of the matrix. The compiler takes seconds
/// for each size of Eigen's own, which gives the same bits.
template <int Rows, int Cols>
Eigen::Matrix<double, Rows, Rows> orthogonal_factor(Eigen::Matrix<double, Rows, Cols> a);

/// Orthonormal basis of the complement of x: the coordinates in which a homogeneous vector has a
/// regular covariance, B' cov B. N x (N-1).
template <int N>
Eigen::Matrix<double, N, N - 1> tangent_basis(const Eigen::Matrix<double, N, 1>& x);

/// x / |x| with the covariance J cov J', J = (I - x_s x_s') / |x|: the covariance loses the part
/// along x, which says nothing of the entity.
template <int N>
Uncertain<N> spherically_normalised(const Uncertain<N>& x);

/// a x b of uncorrelated a and b: the join of two image points (Ok et al. 2011, Eq. 1) or the
/// intersection of two image lines (Eq. 2). The result is not normalised; it is zero if both are
/// the same entity.
Uncertain<3> cross(const Uncertain<3>& a, const Uncertain<3>& b);

/// The unit vector that the rows map nearest to zero: the right singular vector of the smallest
/// singular value.
template <int N>
Eigen::Matrix<double, N, 1> null_vector(const Eigen::Matrix<double, Eigen::Dynamic, N>& rows);

/// d(X_0 / X_h) / dX at a point that is not at infinity.
inline Eigen::Matrix<double, 3, 4> euclidean_jacobian(const Eigen::Vector4d& x) {
  Eigen::Matrix<double, 3, 4> jacobian;
  jacobian << Eigen::Matrix3d::Identity(), -x.hnormalized();
  return jacobian / x.w();
}

}  // namespace ridgeline
