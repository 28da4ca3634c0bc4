// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/pluecker.h"

#include "tests/reconstruct/support/finite_difference.h"
#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline {
namespace {

using test::random_covariance;
using test::random_vector;

constexpr double kPlueckerTol = 1e-12;  // the identities, on input of size 1
constexpr double kWrong = 1e-3;         // what the exchanged form must exceed
constexpr int kTrials = 1000;

Vector6d join(const Eigen::Vector4d& x, const Eigen::Vector4d& y) { return pi_matrix(x) * y; }

/// A unit line through two random points.
Vector6d random_line(test::Random& random) {
  return join(random_vector<4>(random), random_vector<4>(random)).normalized();
}

/// Distance of two homogeneous vectors that may differ by a factor.
template <typename V>
double difference_up_to_scale(const V& a, const V& b) {
  const V u = a.normalized();
  const V v = b.normalized();
  return std::min((u - v).norm(), (u + v).norm());
}

ProjectionMatrix random_camera(test::Random& random) {
  ProjectionMatrix p;
  for (int i = 0; i < 3; ++i) p.row(i) = random_vector<4>(random).transpose();
  return p;
}

TEST(PiMatrix, JoinsPointsToDirectionAndMoment) {
  const Eigen::Vector3d x(1, 2, 3);
  const Eigen::Vector3d y(4, 0, 1);
  const Vector6d line = join(x.homogeneous(), y.homogeneous());
  EXPECT_TRUE(line.head<3>().isApprox(y - x));
  EXPECT_TRUE(line.tail<3>().isApprox(x.cross(y)));
}

TEST(PiBarMatrix, IntersectsPlanesInALineWithinBoth) {
  test::Random random(51);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector4d a = random_vector<4>(random);
    const Eigen::Vector4d b = random_vector<4>(random);
    const Vector6d line = pi_bar_matrix(a) * b;
    EXPECT_NEAR(line.head<3>().dot(line.tail<3>()), 0.0, kPlueckerTol);
    EXPECT_NEAR((pi_matrix(a).transpose() * line).norm(), 0.0, kPlueckerTol);
    EXPECT_NEAR((pi_matrix(b).transpose() * line).norm(), 0.0, kPlueckerTol);
  }
}

TEST(Incidence, TellsAPointOnTheLineAndALineInThePlane) {
  test::Random random(52);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector4d x = random_vector<4>(random);
    const Vector6d line = join(x, random_vector<4>(random));
    EXPECT_NEAR((pi_bar_matrix(x).transpose() * line).norm(), 0.0, kPlueckerTol);
    EXPECT_NEAR((gamma_bar_matrix(line) * x).norm(), 0.0, kPlueckerTol);
  }
}

TEST(Incidence, HasTheSameResidualFromEitherEntity) {
  test::Random random(53);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector4d x = random_vector<4>(random);
    const Vector6d line = random_line(random);
    EXPECT_NEAR((pi_matrix(x).transpose() * line + gamma_matrix(line) * x).norm(), 0.0,
                kPlueckerTol);
    EXPECT_NEAR((pi_bar_matrix(x).transpose() * line + gamma_bar_matrix(line) * x).norm(), 0.0,
                kPlueckerTol);
  }
}

TEST(Incidence, IsNotThatOfTheExchangedForms) {
  const Eigen::Vector4d x(0.3, -0.5, 0.4, 0.7);
  const Eigen::Vector4d y(-0.6, 0.2, 0.5, 0.3);
  const Vector6d line = join(x, y);
  EXPECT_GT((pi_matrix(x).transpose() * line).norm(), kWrong);
  EXPECT_GT((gamma_matrix(line) * x).norm(), kWrong);
  const Vector6d meet = pi_bar_matrix(x) * y;
  EXPECT_GT((pi_bar_matrix(x).transpose() * meet).norm(), kWrong);
  EXPECT_GT((gamma_bar_matrix(meet) * x).norm(), kWrong);
}

TEST(GammaMatrices, IntersectWithAPlaneAndJoinWithAPoint) {
  test::Random random(54);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Vector6d line = random_line(random);
    const Eigen::Vector4d entity = random_vector<4>(random);
    const Eigen::Vector4d point = gamma_matrix(line) * entity;
    EXPECT_NEAR(point.dot(entity), 0.0, kPlueckerTol);
    EXPECT_NEAR((pi_bar_matrix(point).transpose() * line).norm(), 0.0, kPlueckerTol);
    const Eigen::Vector4d plane = gamma_bar_matrix(line) * entity;
    EXPECT_NEAR(plane.dot(entity), 0.0, kPlueckerTol);
    EXPECT_NEAR((pi_matrix(plane).transpose() * line).norm(), 0.0, kPlueckerTol);
  }
}

TEST(LineProjection, IsTheJoinOfTheImagesOfTwoPoints) {
  test::Random random(55);
  for (int trial = 0; trial < kTrials; ++trial) {
    const ProjectionMatrix p = random_camera(random);
    const Eigen::Vector4d x = random_vector<4>(random);
    const Eigen::Vector4d y = random_vector<4>(random);
    const Eigen::Vector3d image_x = p * x;
    const Eigen::Vector3d image_y = p * y;
    EXPECT_NEAR((line_projection(p) * join(x, y) - image_x.cross(image_y)).norm(), 0.0,
                kPlueckerTol);
  }
}

TEST(ReducedRows, AreIndependentForEveryLine) {
  constexpr double kMinRatio = 0.5;
  test::Random random(56);
  const auto ratio = [](const Eigen::Matrix<double, 2, 4>& rows) {
    const Eigen::Vector2d s = Eigen::JacobiSVD<Eigen::MatrixXd>(rows).singularValues();
    return s(1) / s(0);
  };
  for (int trial = 0; trial < kTrials; ++trial) {
    Vector6d line = random_line(random);
    line.tail<3>() *= std::pow(10.0, random.uniform(-4, 4));  // lines of any distance
    const int k = dominant_component(line);
    EXPECT_GT(ratio(select_rows(gamma_matrix(line), line_in_plane_rows(k))), kMinRatio);
    EXPECT_GT(ratio(select_rows(gamma_bar_matrix(line), point_on_line_rows(k))), kMinRatio);
  }
}

TEST(ReducedRows, AreThoseOfTheTable) {
  const std::array<RowPair, 6> point{{{1, 2}, {2, 0}, {0, 1}, {0, 3}, {1, 3}, {2, 3}}};
  const std::array<RowPair, 6> plane{{{0, 3}, {1, 3}, {2, 3}, {1, 2}, {2, 0}, {0, 1}}};
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(point_on_line_rows(k), point.at(static_cast<std::size_t>(k)));
    EXPECT_EQ(line_in_plane_rows(k), plane.at(static_cast<std::size_t>(k)));
  }
}

TEST(ProjectToPlueckerQuadric, GivesTheNearestLine) {
  test::Random random(57);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Vector6d free = random_vector<6>(random);
    const Vector6d line = project_to_pluecker_quadric(free);
    EXPECT_NEAR(line.norm(), 1.0, kPlueckerTol);
    EXPECT_NEAR(line.head<3>().dot(line.tail<3>()), 0.0, kPlueckerTol);
    // no line close to it is closer to the ray of the free vector
    const double cosine = line.dot(free.normalized());
    for (int i = 0; i < 4; ++i) {
      for (const double step : {-1e-3, 1e-3}) {
        const Vector6d beside =
            project_to_pluecker_quadric(line + step * line_tangent_basis(line).col(i));
        EXPECT_LT(beside.dot(free.normalized()), cosine);
      }
    }
  }
}

TEST(ProjectToPlueckerQuadric, KeepsALineAndHasNoAnswerForEqualParts) {
  test::Random random(58);
  const Vector6d line = random_line(random);
  EXPECT_NEAR((project_to_pluecker_quadric(5.0 * line) - line).norm(), 0.0, kPlueckerTol);
  Vector6d equal;
  equal << 1, 2, 3, 1, 2, 3;
  EXPECT_FALSE(project_to_pluecker_quadric(equal).allFinite());
}

TEST(LineTangentBasis, HoldsTheDirectionsThatKeepLengthAndQuadric) {
  test::Random random(59);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Vector6d line = random_line(random);
    const Eigen::Matrix<double, 6, 4> basis = line_tangent_basis(line);
    EXPECT_NEAR((basis.transpose() * basis - Eigen::Matrix4d::Identity()).norm(), 0.0,
                kPlueckerTol);
    EXPECT_NEAR((basis.transpose() * line).norm(), 0.0, kPlueckerTol);
    EXPECT_NEAR((basis.transpose() * dual(line)).norm(), 0.0, kPlueckerTol);
  }
}

TEST(SignedDistance, HandCheckedCase) {
  const Vector6d x_axis = join({0, 0, 0, 1}, {1, 0, 0, 1});
  const Vector6d above = join({5, 0, 3, 1}, {5, 1, 3, 1});
  EXPECT_NEAR(std::abs(signed_distance(x_axis, above)), 3.0, kPlueckerTol);
  EXPECT_NEAR(signed_distance(-2.0 * x_axis, 7.0 * above), -signed_distance(x_axis, above),
              kPlueckerTol);
  EXPECT_FALSE(std::isfinite(signed_distance(x_axis, join({0, 1, 0, 1}, {1, 1, 0, 1}))));
}

TEST(SignedDistance, AgreesWithTheCommonPerpendicular) {
  test::Random random(60);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector3d x = random.vector(-1, 1);
    const Eigen::Vector3d y = random.vector(-1, 1);
    const Eigen::Vector3d d = random.vector(-1, 1);
    const Eigen::Vector3d e = random.vector(-1, 1);
    const Eigen::Vector3d normal = d.cross(e).normalized();
    const Vector6d a = join(x.homogeneous(), (x + d).homogeneous());
    const Vector6d b = join(y.homogeneous(), (y + e).homogeneous());
    EXPECT_NEAR(std::abs(signed_distance(a, b)), std::abs(normal.dot(y - x)), 1e-9);
  }
}

TEST(ProjectionPlane, HoldsEveryPointImagedOnTheLine) {
  test::Random random(61);
  const ProjectionMatrix p = random_camera(random);
  const Eigen::Vector4d x = random_vector<4>(random);
  const Eigen::Vector3d image = p * x;
  const UncertainLine2 line{image.cross(random_vector<3>(random)), random_covariance<3>(random)};
  const UncertainPlane3 plane = projection_plane(p, line);
  EXPECT_NEAR(plane.mean.dot(x), 0.0, kPlueckerTol);
  EXPECT_TRUE(plane.cov.isApprox(p.transpose() * line.cov * p, kPlueckerTol));
}

TEST(ProjectionPlane, AddsTheCovarianceOfTheCamera) {
  test::Random random(62);
  const ProjectionMatrix p = random_camera(random);
  const UncertainLine2 line{random_vector<3>(random), random_covariance<3>(random)};
  const Eigen::Matrix<double, 12, 12> cov_p = random_covariance<12>(random);
  const auto plane_of = [&](const Eigen::Matrix<double, 12, 1>& vec_p) {
    const Eigen::Map<const ProjectionMatrix> camera(vec_p.data());  // column-wise
    return Eigen::Vector4d(camera.transpose() * line.mean);
  };
  const Eigen::Matrix<double, 12, 1> vec_p =
      Eigen::Map<const Eigen::Matrix<double, 12, 1>>(p.data());
  const Eigen::Matrix<double, 4, 12> jacobian = test::central_differences<4, 12>(plane_of, vec_p);
  const Eigen::Matrix4d expected =
      projection_plane(p, line).cov + jacobian * cov_p * jacobian.transpose();
  EXPECT_LT((projection_plane(p, cov_p, line).cov - expected).norm(), 1e-6 * expected.norm());
}

TEST(Intersection, PropagatesBothCovariances) {
  test::Random random(63);
  for (int trial = 0; trial < 100; ++trial) {
    const UncertainPlane3 a{random_vector<4>(random), random_covariance<4>(random)};
    const UncertainPlane3 b{random_vector<4>(random), random_covariance<4>(random)};
    const auto by_a = [&](const Eigen::Vector4d& v) {
      return Vector6d((pi_bar_matrix(v) * b.mean).normalized());
    };
    const auto by_b = [&](const Eigen::Vector4d& v) {
      return Vector6d((pi_bar_matrix(a.mean) * v).normalized());
    };
    const Eigen::Matrix<double, 6, 4> ja = test::central_differences<6, 4>(by_a, a.mean);
    const Eigen::Matrix<double, 6, 4> jb = test::central_differences<6, 4>(by_b, b.mean);
    const Matrix6d expected = ja * a.cov * ja.transpose() + jb * b.cov * jb.transpose();
    const auto line = intersection(a, b);
    ASSERT_TRUE(line);
    EXPECT_LT((line->cov - expected).norm(), 1e-6 * expected.norm());
    EXPECT_LT(difference_up_to_scale(line->mean, by_a(a.mean)), kPlueckerTol);
  }
}

TEST(Intersection, IsEmptyForPlanesThatAreParallelOrTheSame) {
  const Eigen::Matrix4d cov = Eigen::Matrix4d::Identity();
  const UncertainPlane3 ground{{0, 0, 1, 0}, cov};
  EXPECT_FALSE(intersection(ground, ground));
  EXPECT_FALSE(intersection(ground, UncertainPlane3{{0, 0, -3, 5}, cov}));
  EXPECT_FALSE(intersection(ground, UncertainPlane3{{0, 1e-10, 1, 5}, cov}));
  EXPECT_FALSE(intersection(ground, UncertainPlane3{{0, 0, 0, 1}, cov}));  // the plane at infinity
  EXPECT_TRUE(intersection(ground, UncertainPlane3{{0, 1e-8, 1, 5}, cov}));
}

}  // namespace
}  // namespace ridgeline
