// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/adjust_line.h"

#include "tests/reconstruct/support/conditioned_scene.h"
#include "tests/reconstruct/support/finite_difference.h"
#include "tests/support/random.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::ConditionedScene;
using test::kDegree;

using Planes = std::vector<UncertainPlane3>;
using Points = std::vector<UncertainPoint3>;

/// Standard deviations of an independent 3D point, m. That of the height is larger, as from a
/// stereo pair.
const Eigen::Vector3d kPointSigmaM(0.05, 0.05, 0.2);

Planes planes_of(const ObservedTrack& observed) {
  return {observed.base().plane, observed.other().plane};
}

/// A point of the segment, with random error or none without `random`.
UncertainPoint3 point_of(const ConditionedScene& scene,
                         const Segment3& truth,
                         double parameter,
                         test::Random* random) {
  Eigen::Vector3d x = point_at(truth, parameter);
  if (random != nullptr) {
    for (int i = 0; i < 3; ++i) x(i) += random->normal(kPointSigmaM(i));
  }
  UncertainPoint3 point{scene.conditioned(x).homogeneous(), Eigen::Matrix4d::Zero()};
  const Eigen::Vector3d sigma = kPointSigmaM / scene.frames.object.scale_m;
  point.cov.topLeftCorner<3, 3>() = sigma.cwiseAbs2().asDiagonal();
  return spherically_normalised(point);
}

Segment3 segment_at(const ConditionedScene& scene, double theta_deg) {
  return test::make_segment(scene.scene,
                            {scene.scene.left_centre(), theta_deg * kDegree, 100, 3, 5});
}

double difference_up_to_sign(const Vector6d& a, const Vector6d& b) {
  return std::min((a - b).norm(), (a + b).norm());
}

TEST(AdjustLine, WithTwoPlanesIsTheirIntersection) {
  constexpr double kTol = 1e-10;
  const ConditionedScene scene;
  test::Random random(121);
  for (const double theta_deg : {90.0, 45.0, 15.0}) {
    const Segment3 truth = segment_at(scene, theta_deg);
    const auto observed = scene.observe(test::noisy_pair(scene.scene, truth, {}, random));
    const auto line = intersection(observed.base().plane, observed.other().plane);
    const auto adjusted = adjust_line(planes_of(observed), {});
    ASSERT_TRUE(line && adjusted);
    EXPECT_TRUE(adjusted->converged && adjusted->full_rank);
    EXPECT_LT(difference_up_to_sign(adjusted->line.mean, line->mean), kTol);
    EXPECT_LT((adjusted->line.cov - line->cov).norm(), kTol * line->cov.norm() * 1e3);
    EXPECT_LT(adjusted->omega, kTol);
  }
}

TEST(AdjustLine, RecoversAnyLineWithoutNoise) {
  constexpr double kTol = 1e-8;  // conditioned: 3e-7 m
  const ConditionedScene scene;
  for (const double theta_deg : {45.0, 6.0, 1.0, 0.0}) {
    const Segment3 truth = segment_at(scene, theta_deg);
    const auto observed = scene.observe(test::exact_pair(scene.scene, truth));
    const auto adjusted = adjust_line(
        planes_of(observed),
        Points{point_of(scene, truth, 0.1, nullptr), point_of(scene, truth, 0.9, nullptr)});
    ASSERT_TRUE(adjusted) << theta_deg;
    EXPECT_TRUE(adjusted->converged && adjusted->full_rank);
    EXPECT_LT(difference_up_to_sign(adjusted->line.mean, scene.line(truth)), kTol) << theta_deg;
    EXPECT_NEAR(adjusted->line.mean.head<3>().dot(adjusted->line.mean.tail<3>()), 0.0, 1e-12);
    EXPECT_LT(adjusted->omega, kTol);
  }
}

TEST(AdjustLine, SolvesTheBorderedNormalEquations) {
  const ConditionedScene scene;
  test::Random random(122);
  const Segment3 truth = segment_at(scene, 5.0);
  const Planes planes = planes_of(scene.observe(test::exact_pair(scene.scene, truth)));
  const Points points{point_of(scene, truth, 0.1, nullptr), point_of(scene, truth, 0.9, nullptr)};
  const auto adjusted = adjust_line(planes, points);
  ASSERT_TRUE(adjusted);

  const Vector6d& line = adjusted->line.mean;
  const int k = dominant_component(line);
  Eigen::Matrix<double, 8, 8> bordered = Eigen::Matrix<double, 8, 8>::Zero();
  const auto add = [&](const Eigen::Matrix<double, 6, 4>& transposed, const Eigen::Matrix4d& by,
                       const Eigen::Matrix4d& cov, const RowPair& rows) {
    const Eigen::Matrix<double, 2, 6> c = select_rows(transposed.transpose(), rows);
    const Eigen::Matrix<double, 2, 4> g = select_rows(by, rows);
    bordered.topLeftCorner<6, 6>() += c.transpose() * (g * cov * g.transpose()).inverse() * c;
  };
  for (const auto& p : planes) {
    add(pi_matrix(p.mean), gamma_matrix(line), p.cov, line_in_plane_rows(k));
  }
  for (const auto& p : points) {
    add(pi_bar_matrix(p.mean), gamma_bar_matrix(line), p.cov, point_on_line_rows(k));
  }
  bordered.block<6, 1>(0, 6) = dual(line);
  bordered.block<6, 1>(0, 7) = line;
  bordered.bottomLeftCorner<2, 6>() = bordered.topRightCorner<6, 2>().transpose();
  const Matrix6d expected = bordered.inverse().topLeftCorner<6, 6>();
  EXPECT_LT((adjusted->line.cov - expected).norm(), 1e-6 * expected.norm());
}

TEST(AdjustLine, HasTheCovarianceOfItsDifferentialByTheEntities) {
  const ConditionedScene scene;
  for (const double theta_deg : {45.0, 2.0, 0.0}) {
    const Segment3 truth = segment_at(scene, theta_deg);
    const Planes planes = planes_of(scene.observe(test::exact_pair(scene.scene, truth)));
    const Points points{point_of(scene, truth, 0.1, nullptr), point_of(scene, truth, 0.9, nullptr)};
    const Vector6d line = adjust_line(planes, points)->line.mean;
    const auto oriented = [&](const std::optional<AdjustedLine>& adjusted) {
      const Vector6d& m = adjusted->line.mean;
      return Vector6d(m.dot(line) < 0.0 ? -m : m);
    };
    Matrix6d expected = Matrix6d::Zero();
    for (std::size_t i = 0; i < 2; ++i) {
      const auto by_plane = [&](const Eigen::Vector4d& a) {
        Planes changed = planes;
        changed[i].mean = a;
        return oriented(adjust_line(changed, points));
      };
      const auto by_point = [&](const Eigen::Vector4d& x) {
        Points changed = points;
        changed[i].mean = x;
        return oriented(adjust_line(planes, changed));
      };
      const Eigen::Matrix<double, 6, 4> jp =
          test::central_differences<6, 4>(by_plane, planes[i].mean);
      const Eigen::Matrix<double, 6, 4> jx =
          test::central_differences<6, 4>(by_point, points[i].mean);
      expected += jp * planes[i].cov * jp.transpose() + jx * points[i].cov * jx.transpose();
    }
    const Matrix6d cov = adjust_line(planes, points)->line.cov;
    EXPECT_LT((cov - expected).norm(), 1e-4 * expected.norm()) << theta_deg;
  }
}

TEST(AdjustLine, HasTheStatedErrorsAndOmegaWithIndependentPoints) {
  constexpr int kTrials = 600;
  const ConditionedScene scene;
  test::Random random(123);
  for (const double theta_deg : {45.0, 6.0, 2.0, 0.0}) {
    const Segment3 truth = segment_at(scene, theta_deg);
    const Vector6d line = scene.line(truth);
    double sum_nees = 0.0;
    double sum_omega = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const auto observed = scene.observe(test::noisy_pair(scene.scene, truth, {}, random));
      const auto adjusted =
          adjust_line(planes_of(observed), Points{point_of(scene, truth, 0.0, &random),
                                                  point_of(scene, truth, 0.5, &random),
                                                  point_of(scene, truth, 1.0, &random)});
      ASSERT_TRUE(adjusted && adjusted->converged);
      sum_nees += test::nees(adjusted->line, line, line_tangent_basis(line));
      sum_omega += adjusted->omega;
    }
    // five entities, ten conditions, four freedoms; false alarm 1 % each
    EXPECT_NEAR(sum_nees / kTrials, 4.0, test::chi_square_mean_band(4.0, kTrials)) << theta_deg;
    EXPECT_NEAR(sum_omega / kTrials, 6.0, test::chi_square_mean_band(6.0, kTrials)) << theta_deg;
  }
}

TEST(AdjustLine, OfTwoPlanesHasTheStatedErrors) {
  constexpr int kTrials = 1000;
  const ConditionedScene scene;
  test::Random random(124);
  // nearer to the epipolar line the linear covariance holds for smaller errors only
  for (const auto& [theta_deg, factor] : {std::pair(45.0, 1.0), std::pair(6.0, 0.3)}) {
    const Segment3 truth = segment_at(scene, theta_deg);
    const Vector6d line = scene.line(truth);
    double sum = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const auto observed =
          scene.observe(test::noisy_pair(scene.scene, truth, test::scaled({}, factor), random));
      sum += test::nees(*intersection(observed.base().plane, observed.other().plane), line,
                        line_tangent_basis(line));
    }
    EXPECT_NEAR(sum / kTrials, 4.0, test::chi_square_mean_band(4.0, kTrials)) << theta_deg;
  }
}

TEST(AdjustLine, OfThreePlanesHasTwoRedundantConditions) {
  constexpr int kTrials = 1000;
  const ConditionedScene scene;
  ProjectionMatrix third = scene.scene.cameras[0];
  third.col(3) -= third.leftCols<3>() * Eigen::Vector3d(100, 150, 10);
  const ConditionedView& left = scene.frames.views[0];
  const ImageConditioning image{project(third, Eigen::Vector3d(0, 0, 2)), left.image.scale_px};
  ConditionedViews frames = scene.frames;
  frames.views.push_back({conditioned_camera(third, image, scene.frames.object), image});
  const Segment3 truth = segment_at(scene, 60.0);
  const Vector6d line = scene.line(truth);
  test::Random random(125);
  double sum_nees = 0.0;
  double sum_omega = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    Planes planes = planes_of(scene.observe(test::noisy_pair(scene.scene, truth, {}, random)));
    const UncertainSegment2 segment = test::noisy(project(third, truth), {}, random);
    planes.push_back(observe(frames, 2, segment, LineCovariance::kCentroid).plane);
    const auto adjusted = adjust_line(planes, {});
    ASSERT_TRUE(adjusted && adjusted->converged);
    sum_nees += test::nees(adjusted->line, line, line_tangent_basis(line));
    sum_omega += adjusted->omega;
  }
  EXPECT_NEAR(sum_nees / kTrials, 4.0, test::chi_square_mean_band(4.0, kTrials));
  EXPECT_NEAR(sum_omega / kTrials, 2.0, test::chi_square_mean_band(2.0, kTrials));
}

TEST(AdjustLine, OfCoincidentPlanesNeedsTwoPoints) {
  const ConditionedScene scene;
  const Segment3 truth = segment_at(scene, 0.0);
  const ObservedLine left = scene.observe(test::exact_pair(scene.scene, truth)).base();
  const Planes planes{left.plane, left.plane};
  Points points;
  for (const auto& [parameter, full_rank] : {std::pair(0.1, false), std::pair(0.9, true)}) {
    points.push_back(point_of(scene, truth, parameter, nullptr));
    const auto adjusted = adjust_line(planes, points);
    ASSERT_TRUE(adjusted);
    EXPECT_EQ(adjusted->full_rank, full_rank);
  }
  points.back() = points.front();  // two incidences at one place are one
  EXPECT_FALSE(adjust_line(planes, points)->full_rank);
}

TEST(AdjustLine, NullDirectionsAreTwoOneAndNoneWithMorePoints) {
  const ConditionedScene scene;
  const Segment3 truth = segment_at(scene, 0.0);
  const ObservedLine left = scene.observe(test::exact_pair(scene.scene, truth)).base();
  const UncertainPoint3 a = point_of(scene, truth, 0.1, nullptr);
  const UncertainPoint3 b = point_of(scene, truth, 0.9, nullptr);
  // free directions carry no increment and no covariance, so the line is one of many
  const auto free_directions = [&](const Points& points) {
    const auto adjusted = adjust_line(Planes{left.plane, left.plane}, points);
    const Eigen::Matrix<double, 6, 4> basis = line_tangent_basis(adjusted->line.mean);
    const Eigen::Matrix4d cov = basis.transpose() * adjusted->line.cov * basis;
    return 4 - Eigen::FullPivLU<Eigen::Matrix4d>(cov).setThreshold(1e-9).rank();
  };
  EXPECT_EQ(free_directions({}), 2);
  EXPECT_EQ(free_directions({a}), 1);
  EXPECT_EQ(free_directions({a, b}), 0);
}

TEST(AdjustLine, IgnoresTheSignOfItsEntities) {
  const ConditionedScene scene;
  test::Random random(126);
  const Segment3 truth = segment_at(scene, 3.0);
  Planes planes = planes_of(scene.observe(test::noisy_pair(scene.scene, truth, {}, random)));
  Points points{point_of(scene, truth, 0.1, &random), point_of(scene, truth, 0.9, &random)};
  const auto expected = adjust_line(planes, points);
  planes[0].mean *= -1.0;
  points[1].mean *= -1.0;
  const auto actual = adjust_line(planes, points);
  EXPECT_LT(difference_up_to_sign(actual->line.mean, expected->line.mean), 1e-10);
  EXPECT_NEAR(actual->omega, expected->omega, 1e-8);
}

TEST(AdjustLine, IsEmptyForASingleEntity) {
  const ConditionedScene scene;
  const Segment3 truth = segment_at(scene, 30.0);
  const Planes planes = planes_of(scene.observe(test::exact_pair(scene.scene, truth)));
  EXPECT_FALSE(adjust_line(std::span(planes).first(1), {}));
  EXPECT_FALSE(adjust_line({}, {}));
}

}  // namespace
}  // namespace ridgeline::reconstruct
