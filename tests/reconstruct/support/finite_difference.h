// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/random.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace ridgeline::test {

/// Jacobian of an N-vector function of an M-vector, steps of 1e-6 of each component's size:
/// relative error about 1e-10 for a function of curvature 1.
template <int N, int M, typename Function>
Eigen::Matrix<double, N, M> central_differences(const Function& function,
                                                const Eigen::Matrix<double, M, 1>& x) {
  Eigen::Matrix<double, N, M> jacobian;
  for (int i = 0; i < M; ++i) {
    const double step = 1e-6 * std::max(std::abs(x(i)), 0.1);
    Eigen::Matrix<double, M, 1> above = x;
    Eigen::Matrix<double, M, 1> below = x;
    above(i) += step;
    below(i) -= step;
    const Eigen::Matrix<double, N, 1> high = function(above);
    const Eigen::Matrix<double, N, 1> low = function(below);
    jacobian.col(i) = (high - low) / (above(i) - below(i));
  }
  return jacobian;
}

/// A vector with components in [-1, 1], at least one of them not small.
template <int N>
Eigen::Matrix<double, N, 1> random_vector(Random& random) {
  Eigen::Matrix<double, N, 1> x;
  do {
    for (int i = 0; i < N; ++i) x(i) = random.uniform(-1, 1);
  } while (x.norm() < 0.3);
  return x;
}

/// A regular covariance matrix with standard deviations of about 1e-3.
template <int N>
Eigen::Matrix<double, N, N> random_covariance(Random& random) {
  Eigen::Matrix<double, N, N> root;
  for (int i = 0; i < N; ++i) root.col(i) = 1e-3 * random_vector<N>(random);
  return root * root.transpose();
}

}  // namespace ridgeline::test
