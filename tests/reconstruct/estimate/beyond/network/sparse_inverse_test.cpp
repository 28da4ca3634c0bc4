// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/sparse_inverse.h"

#include "tests/support/random.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <stdexcept>

namespace ridgeline::reconstruct {
namespace {

/// A regular matrix with about `per_row` elements per row off the diagonal.
Eigen::SparseMatrix<double> random_matrix(int n, int per_row, test::Random& random) {
  Eigen::MatrixXd matrix = 0.5 * Eigen::MatrixXd::Identity(n, n);
  for (int k = 0; k < n * per_row; ++k) {
    const auto i = static_cast<int>(random.uniform(0, n));
    const auto j = static_cast<int>(random.uniform(0, n));
    if (i == j) continue;
    Eigen::VectorXd row = Eigen::VectorXd::Zero(n);  // as a condition between two unknowns adds
    row(i) = random.uniform(-1, 1);
    row(j) = random.uniform(-1, 1);
    matrix += row * row.transpose();
  }
  return matrix.sparseView();
}

TEST(SparseInverse, IsTheInverseWhereTheMatrixIsNotZero) {
  constexpr double kRounding = 1e-10;
  test::Random random(311);
  for (const int per_row : {0, 1, 4}) {
    const Eigen::SparseMatrix<double> matrix = random_matrix(60, per_row, random);
    const Eigen::MatrixXd expected = Eigen::MatrixXd(matrix).inverse();
    auto inverse = SparseInverse::of(matrix.triangularView<Eigen::Lower>());
    ASSERT_TRUE(inverse);
    inverse->invert();
    for (int j = 0; j < matrix.outerSize(); ++j) {
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it) {
        EXPECT_NEAR(inverse->at(static_cast<int>(it.row()), j), expected(it.row(), j), kRounding);
      }
    }
  }
}

TEST(SparseInverse, Solves) {
  test::Random random(312);
  const Eigen::SparseMatrix<double> matrix = random_matrix(60, 3, random);
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(60, -1.0, 2.0);
  const auto factors = SparseInverse::of(matrix.triangularView<Eigen::Lower>());
  EXPECT_LT((factors->solve(matrix * x) - x).norm(), 1e-10);
}

TEST(SparseInverse, RefusesWhatIsNotPositiveDefinite) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(3, 3);
  matrix(1, 1) = 0.0;
  EXPECT_FALSE(SparseInverse::of(matrix.sparseView()));
  matrix(1, 1) = -1.0;
  EXPECT_FALSE(SparseInverse::of(matrix.sparseView()));
}

TEST(SparseInverse, ThrowsOutsideOfThePatternAndBeforeTheInversion) {
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(3, 3);
  auto inverse = SparseInverse::of(matrix.sparseView());
  EXPECT_THROW(static_cast<void>(inverse->at(0, 0)), std::out_of_range);
  inverse->invert();
  EXPECT_DOUBLE_EQ(inverse->at(0, 0), 1.0);
  EXPECT_THROW(static_cast<void>(inverse->at(0, 1)), std::out_of_range);
}

}  // namespace
}  // namespace ridgeline::reconstruct
