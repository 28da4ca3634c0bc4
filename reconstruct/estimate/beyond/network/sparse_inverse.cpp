// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/sparse_inverse.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <stdexcept>

namespace ridgeline::reconstruct {

std::optional<SparseInverse> SparseInverse::of(const Eigen::SparseMatrix<double>& lower) {
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(lower);
  if (ldlt.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd diagonal = ldlt.vectorD();  // once: vectorD() copies it
  if (!(diagonal.minCoeff() > 0.0)) return std::nullopt;
  SparseInverse result;
  const Eigen::SparseMatrix<double> factor = ldlt.matrixL();
  const auto n = static_cast<std::size_t>(factor.cols());
  result.columns_.resize(n);
  for (std::size_t j = 0; j < n; ++j) {
    SparseColumn& column = result.columns_[j];
    column.diagonal = diagonal(static_cast<Eigen::Index>(j));
    for (Eigen::SparseMatrix<double>::InnerIterator it(factor, static_cast<Eigen::Index>(j)); it;
         ++it) {
      if (it.row() == it.col()) continue;
      column.rows.push_back(static_cast<int>(it.row()));
      column.factor.push_back(it.value());
    }
  }
  const auto& order = ldlt.permutationP().indices();
  result.place_.assign(order.data(), order.data() + order.size());
  return result;
}

Eigen::VectorXd SparseInverse::solve(const Eigen::VectorXd& right) const {
  const auto n = static_cast<Eigen::Index>(columns_.size());
  Eigen::VectorXd x(n);
  for (Eigen::Index i = 0; i < n; ++i) x(place_[static_cast<std::size_t>(i)]) = right(i);
  for (Eigen::Index j = 0; j < n; ++j) {
    const SparseColumn& column = columns_[static_cast<std::size_t>(j)];
    for (std::size_t k = 0; k < column.rows.size(); ++k)
      x(column.rows[k]) -= column.factor[k] * x(j);
  }
  for (Eigen::Index j = n; j-- > 0;) {
    const SparseColumn& column = columns_[static_cast<std::size_t>(j)];
    x(j) /= column.diagonal;
    for (std::size_t k = 0; k < column.rows.size(); ++k)
      x(j) -= column.factor[k] * x(column.rows[k]);
  }
  Eigen::VectorXd result(n);
  for (Eigen::Index i = 0; i < n; ++i) result(i) = x(place_[static_cast<std::size_t>(i)]);
  return result;
}

double SparseInverse::inverse_at(int row, int column) const {
  if (row == column) return columns_[static_cast<std::size_t>(column)].inverse_diagonal;
  const SparseColumn& c = columns_[static_cast<std::size_t>(std::min(row, column))];
  const int wanted = std::max(row, column);
  const auto found = std::lower_bound(c.rows.begin(), c.rows.end(), wanted);
  if (found == c.rows.end() || *found != wanted) {
    throw std::out_of_range("SparseInverse: element outside of the pattern");
  }
  return c.inverse[static_cast<std::size_t>(found - c.rows.begin())];
}

/// The columns are computed from the last to the first: Z_ij = [i = j] / D_j - sum over k > j of
/// L_kj Z_ik.
void SparseInverse::invert() {
  for (std::size_t j = columns_.size(); j-- > 0;) {
    SparseColumn& column = columns_[j];
    column.inverse.resize(column.rows.size());
    for (std::size_t i = 0; i < column.rows.size(); ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < column.rows.size(); ++k) {
        sum += column.factor[k] * inverse_at(column.rows[i], column.rows[k]);
      }
      column.inverse[i] = -sum;
    }
    column.inverse_diagonal = 1.0 / column.diagonal;
    for (std::size_t k = 0; k < column.rows.size(); ++k) {
      column.inverse_diagonal -= column.factor[k] * column.inverse[k];
    }
  }
  is_inverted_ = true;
}

double SparseInverse::at(int row, int column) const {
  if (!is_inverted_) throw std::out_of_range("SparseInverse: not inverted");
  return inverse_at(place_.at(static_cast<std::size_t>(row)),
                    place_.at(static_cast<std::size_t>(column)));
}

}  // namespace ridgeline::reconstruct
