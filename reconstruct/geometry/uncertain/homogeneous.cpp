// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/homogeneous.h"

#include <Eigen/Householder>
#include <Eigen/SVD>

namespace ridgeline {

template <int M, int N>
Eigen::Matrix<double, M, M> propagated(const Eigen::Matrix<double, M, N>& jacobian,
                                       const Eigen::Matrix<double, N, N>& cov) {
  return jacobian * cov * jacobian.transpose();
}

template <int Rows, int Cols>
Eigen::Matrix<double, Rows, Rows> orthogonal_factor(Eigen::Matrix<double, Rows, Cols> a) {
  Eigen::Matrix<double, Cols, 1> tau;
  Eigen::Matrix<double, Rows, 1> workspace;
  for (int k = 0; k < Cols; ++k) {
    double beta = 0.0;
    a.col(k).tail(Rows - k).makeHouseholderInPlace(tau(k), beta);
    if (k + 1 == Cols) break;
    a.bottomRightCorner(Rows - k, Cols - k - 1)
        .applyHouseholderOnTheLeft(a.col(k).tail(Rows - k - 1), tau(k), workspace.data());
  }
  Eigen::Matrix<double, Rows, Rows> q = Eigen::Matrix<double, Rows, Rows>::Identity();
  for (int k = Cols - 1; k >= 0; --k) {
    q.bottomRightCorner(Rows - k, Rows - k)
        .applyHouseholderOnTheLeft(a.col(k).tail(Rows - k - 1), tau(k), workspace.data());
  }
  return q;
}

template <int N>
Eigen::Matrix<double, N, N - 1> tangent_basis(const Eigen::Matrix<double, N, 1>& x) {
  return orthogonal_factor<N, 1>(x).template rightCols<N - 1>();
}

template <int N>
Uncertain<N> spherically_normalised(const Uncertain<N>& x) {
  const double norm = x.mean.norm();
  const Eigen::Matrix<double, N, 1> unit = x.mean / norm;
  const Eigen::Matrix<double, N, N> jacobian =
      (Eigen::Matrix<double, N, N>::Identity() - unit * unit.transpose()) / norm;
  return {unit, propagated<N, N>(jacobian, x.cov)};
}

Uncertain<3> cross(const Uncertain<3>& a, const Uncertain<3>& b) {
  return {a.mean.cross(b.mean),
          propagated<3, 3>(skew(a.mean), b.cov) + propagated<3, 3>(skew(b.mean), a.cov)};
}

template <int N>
Eigen::Matrix<double, N, 1> null_vector(const Eigen::Matrix<double, Eigen::Dynamic, N>& rows) {
  return rows.jacobiSvd(Eigen::ComputeFullV).matrixV().col(N - 1);
}

#define RIDGELINE_PROPAGATED(M, N)                                                          \
  template Eigen::Matrix<double, M, M> propagated<M, N>(const Eigen::Matrix<double, M, N>&, \
                                                        const Eigen::Matrix<double, N, N>&)
RIDGELINE_PROPAGATED(2, 3);
RIDGELINE_PROPAGATED(2, 4);
RIDGELINE_PROPAGATED(2, 6);
RIDGELINE_PROPAGATED(3, 3);
RIDGELINE_PROPAGATED(3, 4);
RIDGELINE_PROPAGATED(4, 4);
RIDGELINE_PROPAGATED(4, 12);
RIDGELINE_PROPAGATED(6, 4);
RIDGELINE_PROPAGATED(6, 6);
#undef RIDGELINE_PROPAGATED

template Eigen::Matrix<double, 6, 6> orthogonal_factor<6, 2>(Eigen::Matrix<double, 6, 2>);
template Eigen::Matrix<double, 3, 2> tangent_basis<3>(const Eigen::Vector3d&);
template Eigen::Matrix<double, 4, 3> tangent_basis<4>(const Eigen::Vector4d&);
template Eigen::Vector4d null_vector<4>(const Eigen::Matrix<double, Eigen::Dynamic, 4>&);
template Eigen::Matrix<double, 6, 1> null_vector<6>(
    const Eigen::Matrix<double, Eigen::Dynamic, 6>&);
template Uncertain<3> spherically_normalised<3>(const Uncertain<3>&);
template Uncertain<4> spherically_normalised<4>(const Uncertain<4>&);
template Uncertain<6> spherically_normalised<6>(const Uncertain<6>&);

}  // namespace ridgeline
