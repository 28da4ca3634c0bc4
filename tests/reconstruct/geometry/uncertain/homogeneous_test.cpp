// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/homogeneous.h"

#include "tests/reconstruct/support/finite_difference.h"
#include "tests/support/random.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline {
namespace {

using test::random_covariance;
using test::random_vector;

constexpr double kHomogeneousTol = 1e-12;  // roundings of quantities of size 1
constexpr double kJacobianTol = 1e-6;      // relative error of central differences

TEST(Skew, IsTheCrossProduct) {
  test::Random random(41);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d a = random.vector(-1, 1);
    const Eigen::Vector3d b = random.vector(-1, 1);
    EXPECT_NEAR((skew(a) * b - a.cross(b)).norm(), 0.0, kHomogeneousTol);
  }
}

TEST(NullVector, IsTheUnitVectorThatTheRowsMapToZero) {
  test::Random random(45);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Matrix<double, 6, 1> x = random_vector<6>(random).normalized();
    Eigen::Matrix<double, Eigen::Dynamic, 6> rows(9, 6);
    for (int i = 0; i < 9; ++i) {
      const Eigen::Matrix<double, 6, 1> row = random_vector<6>(random);
      rows.row(i) = row - row.dot(x) * x;
    }
    const Eigen::Matrix<double, 6, 1> found = null_vector<6>(rows);
    EXPECT_NEAR(found.norm(), 1.0, kHomogeneousTol);
    EXPECT_NEAR(std::abs(found.dot(x)), 1.0, kHomogeneousTol);
  }
}

TEST(Propagated, IsTheCovarianceOfALinearFunction) {
  test::Random random(46);
  const Eigen::Matrix4d cov = random_covariance<4>(random);
  const Eigen::Matrix<double, 2, 4> jacobian =
      (Eigen::Matrix<double, 2, 4>() << 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0).finished();
  const Eigen::Matrix2d expected =
      (Eigen::Matrix2d() << cov(0, 0), 2.0 * cov(0, 2), 2.0 * cov(2, 0), 4.0 * cov(2, 2))
          .finished();
  EXPECT_NEAR((propagated(jacobian, cov) - expected).norm(), 0.0, kHomogeneousTol);
}

TEST(TangentBasis, IsOrthonormalAndOrthogonalToTheVector) {
  test::Random random(42);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector4d x = random_vector<4>(random);
    const Eigen::Matrix<double, 4, 3> basis = tangent_basis<4>(x);
    EXPECT_NEAR((basis.transpose() * x).norm(), 0.0, kHomogeneousTol);
    EXPECT_NEAR((basis.transpose() * basis - Eigen::Matrix3d::Identity()).norm(), 0.0,
                kHomogeneousTol);
  }
}

TEST(SphericallyNormalised, HasItsDifferentialAsJacobian) {
  test::Random random(43);
  for (int trial = 0; trial < 100; ++trial) {
    const Uncertain<4> x{random_vector<4>(random), random_covariance<4>(random)};
    const auto normalise = [](const Eigen::Vector4d& v) { return Eigen::Vector4d(v.normalized()); };
    const Eigen::Matrix4d jacobian = test::central_differences<4, 4>(normalise, x.mean);
    const Uncertain<4> unit = spherically_normalised(x);
    EXPECT_NEAR(unit.mean.norm(), 1.0, kHomogeneousTol);
    const Eigen::Matrix4d expected = jacobian * x.cov * jacobian.transpose();
    EXPECT_LT((unit.cov - expected).norm(), kJacobianTol * expected.norm());
    EXPECT_NEAR((unit.cov * unit.mean).norm(), 0.0, kHomogeneousTol * x.cov.norm() * 100);
  }
}

TEST(SphericallyNormalised, ChangesNothingTwice) {
  test::Random random(44);
  const Uncertain<6> x =
      spherically_normalised(Uncertain<6>{random_vector<6>(random), random_covariance<6>(random)});
  const Uncertain<6> again = spherically_normalised(x);
  EXPECT_TRUE(again.mean.isApprox(x.mean, kHomogeneousTol));
  EXPECT_TRUE(again.cov.isApprox(x.cov, kHomogeneousTol));
}

TEST(Cross, PropagatesBothCovariances) {
  test::Random random(45);
  for (int trial = 0; trial < 100; ++trial) {
    const Uncertain<3> a{random_vector<3>(random), random_covariance<3>(random)};
    const Uncertain<3> b{random_vector<3>(random), random_covariance<3>(random)};
    const auto by_a = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v.cross(b.mean)); };
    const auto by_b = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(a.mean.cross(v)); };
    const Eigen::Matrix3d ja = test::central_differences<3, 3>(by_a, a.mean);
    const Eigen::Matrix3d jb = test::central_differences<3, 3>(by_b, b.mean);
    const Eigen::Matrix3d expected = ja * a.cov * ja.transpose() + jb * b.cov * jb.transpose();
    EXPECT_LT((cross(a, b).cov - expected).norm(), kJacobianTol * expected.norm());
  }
}

TEST(Cross, JoinsPointsAndIntersectsLines) {
  const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
  const Uncertain<3> x_axis = cross({{0, 0, 1}, none}, {{5, 0, 1}, none});
  const Uncertain<3> y_is_x = cross({{0, 0, 1}, none}, {{2, 2, 1}, none});
  EXPECT_NEAR(x_axis.mean.dot(Eigen::Vector3d(-3, 0, 1)), 0.0, kHomogeneousTol);
  EXPECT_NEAR(cross(x_axis, y_is_x).mean.hnormalized().norm(), 0.0, kHomogeneousTol);
}

TEST(EuclideanJacobian, AgreesWithCentralDifferences) {
  test::Random random(46);
  for (int trial = 0; trial < 100; ++trial) {
    Eigen::Vector4d x = random_vector<4>(random);
    x.w() = random.uniform(-1.0, -0.5);  // either sign of the homogeneous part
    const auto euclidean = [](const Eigen::Vector4d& v) {
      return Eigen::Vector3d(v.hnormalized());
    };
    const Eigen::Matrix<double, 3, 4> expected = test::central_differences<3, 4>(euclidean, x);
    EXPECT_LT((euclidean_jacobian(x) - expected).norm(), kJacobianTol * expected.norm());
  }
}

}  // namespace
}  // namespace ridgeline
