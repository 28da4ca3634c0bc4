// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ridgeline {

/// A vector with the covariance of its components. The covariance of a homogeneous vector is
/// singular (its scale is not a random quantity) and is never inverted directly; see
/// tangent_basis().
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

/// Covariance J cov J' of a function with Jacobian J, applied to a quantity with covariance cov.
/// The templates of this file are instantiated in homogeneous.cpp for the sizes listed there,
/// because compiling Eigen takes seconds for each size.
template <int M, int N>
Eigen::Matrix<double, M, M> propagated(const Eigen::Matrix<double, M, N>& jacobian,
                                       const Eigen::Matrix<double, N, N>& cov);

/// Q of the QR decomposition of a matrix, by Householder reflections. Its last columns are an
/// orthonormal basis of the orthogonal complement of the columns of the matrix. Eigen's own
/// decomposition gives the same bits but takes seconds to compile for each size.
template <int Rows, int Cols>
Eigen::Matrix<double, Rows, Rows> orthogonal_factor(Eigen::Matrix<double, Rows, Cols> a);

/// Orthonormal basis B of the orthogonal complement of x, N x (N-1). In its coordinates the
/// covariance of a homogeneous vector, B' cov B, is regular.
template <int N>
Eigen::Matrix<double, N, N - 1> tangent_basis(const Eigen::Matrix<double, N, 1>& x);

/// x / |x| with the covariance J cov J', J = (I - x_s x_s') / |x|: the covariance loses its part
/// along x, which has no geometric meaning.
template <int N>
Uncertain<N> spherically_normalised(const Uncertain<N>& x);

/// a x b for uncorrelated a and b: the join of two image points (Ok et al. 2011, Eq. 1) or the
/// intersection of two image lines (Eq. 2). The result is not normalised; it is zero if a and b are
/// the same point or line.
Uncertain<3> cross(const Uncertain<3>& a, const Uncertain<3>& b);

/// The unit vector x for which |rows x| is smallest: the right singular vector of the smallest
/// singular value.
template <int N>
Eigen::Matrix<double, N, 1> null_vector(const Eigen::Matrix<double, Eigen::Dynamic, N>& rows);

/// d(X_0 / X_h) / dX at a finite point.
inline Eigen::Matrix<double, 3, 4> euclidean_jacobian(const Eigen::Vector4d& x) {
  Eigen::Matrix<double, 3, 4> jacobian;
  jacobian << Eigen::Matrix3d::Identity(), -x.hnormalized();
  return jacobian / x.w();
}

}  // namespace ridgeline
