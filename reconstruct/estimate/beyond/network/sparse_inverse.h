// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// Cholesky factors of a symmetric positive definite sparse matrix, and those elements of its
/// inverse that lie in the pattern of the factors. They suffice for the covariances of connected
/// unknowns. Computing them takes about as long as the factorisation (Takahashi et al. 1973), while
/// the whole inverse is dense.
class SparseInverse {
 public:
  /// Factorises a matrix given by its lower triangle. Empty if the matrix is not positive definite.
  static std::optional<SparseInverse> of(const Eigen::SparseMatrix<double>& lower);

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  /// Computes the elements of the inverse in the pattern of the factors.
  void invert();
  /// Element of the inverse; throws std::out_of_range outside the pattern or before invert().
  [[nodiscard]] double at(int row, int column) const;

 private:
  /// A column of the unit lower triangular factor below its diagonal, rows ascending.
  struct SparseColumn {
    std::vector<int> rows;
    std::vector<double> factor, inverse;
    double diagonal = 0.0;          ///< diagonal element of D
    double inverse_diagonal = 0.0;  ///< diagonal element of the inverse
  };
  [[nodiscard]] double inverse_at(int row, int column) const;

  std::vector<SparseColumn> columns_;
  std::vector<int> place_;  ///< position of each unknown in the elimination order
  bool is_inverted_ = false;
};

}  // namespace ridgeline::reconstruct
