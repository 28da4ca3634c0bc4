// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/line_geometry.h"

#include "tests/reconstruct/support/conditioned_scene.h"
#include "tests/reconstruct/support/finite_difference.h"
#include "tests/support/random.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace ridgeline::reconstruct {
namespace {

using test::ConditionedScene;
using test::kDegree;

const Matrix6d kNoCovariance = Matrix6d::Zero();

TEST(Endpoints, AreThoseOfTheSegmentThatWasSeen) {
  constexpr double kTol = 1e-9;  // conditioned: 3e-8 m
  const ConditionedScene scene;
  test::Random random(101);
  for (int trial = 0; trial < 1000; ++trial) {
    const Segment3 truth{random.vector(-15, 15), random.vector(-15, 15)};
    const auto observed = scene.observe(test::exact_pair(scene.scene, truth));
    for (std::size_t j = 0; j < 2; ++j) {
      const auto ends = endpoints({scene.line(truth), kNoCovariance}, scene.frames.views[j],
                                  observed.observations[j], scene.frames.views);
      ASSERT_TRUE(ends);
      EXPECT_LT((ends->segment.start - scene.conditioned(truth.start)).norm(), kTol);
      EXPECT_LT((ends->segment.end - scene.conditioned(truth.end)).norm(), kTol);
    }
  }
}

TEST(Endpoints, PropagateTheLineLikeCentralDifferences) {
  const ConditionedScene scene;
  const ConditionedView& view = scene.frames.views[0];
  test::Random random(102);
  for (int trial = 0; trial < 50; ++trial) {
    const Segment3 truth{random.vector(-15, 15), random.vector(-15, 15)};
    ObservedLine observed = scene.observe(test::exact_pair(scene.scene, truth)).base();
    observed.sigma_e = 0.0;
    const auto ends = [&](const Vector6d& line) {
      const auto both = endpoints({line, kNoCovariance}, view, observed, scene.frames.views);
      Vector6d stacked;
      stacked << both->segment.start, both->segment.end;
      return stacked;
    };
    const Matrix6d jacobian = test::central_differences<6, 6>(ends, scene.line(truth));
    const Matrix6d cov = test::random_covariance<6>(random);
    const Matrix6d expected = jacobian * cov * jacobian.transpose();
    const auto actual = endpoints({scene.line(truth), cov}, view, observed, scene.frames.views);
    EXPECT_LT((actual->cov - expected).norm(), 1e-6 * expected.norm());
  }
}

TEST(Endpoints, MoveAlongTheLineWithTheImageEndpoint) {
  const ConditionedScene scene;
  const Segment3 truth{{-3, 1, 2}, {4, 6, 7}};
  const ObservedLine observed = scene.observe(test::exact_pair(scene.scene, truth)).base();
  const auto ends = endpoints({scene.line(truth), kNoCovariance}, scene.frames.views[0], observed,
                              scene.frames.views);
  ASSERT_TRUE(ends);
  const Eigen::Vector3d along = (truth.end - truth.start).normalized();
  const Eigen::Matrix3d cov = ends->cov.topLeftCorner<3, 3>();
  // 1 px is 8 cm on the ground, a little more along a climbing line
  const double sigma_m = scene.frames.object.scale_m * std::sqrt(along.dot(cov * along));
  EXPECT_GT(sigma_m, 0.07);
  EXPECT_LT(sigma_m, 0.12);
  EXPECT_NEAR(cov.trace(), along.dot(cov * along), 1e-9 * cov.trace());
  EXPECT_EQ((ends->cov.topRightCorner<3, 3>().norm()), 0.0);
}

TEST(Endpoints, HaveTheStatedCovarianceUnderNoise) {
  constexpr int kTrials = 1000;
  const ConditionedScene scene;
  test::Random random(103);
  const Segment3 truth =
      test::make_segment(scene.scene, {scene.scene.left_centre(), 45 * kDegree, 100, 2, 5});
  double sum = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto observed =
        scene.observe(test::noisy_pair(scene.scene, truth, test::scaled({}, 0.5), random));
    const auto line = intersection(observed.base().plane, observed.other().plane);
    const auto ends = endpoints(*line, scene.frames.views[0], observed.base(), scene.frames.views);
    Vector6d error;
    error << ends->segment.start - scene.conditioned(truth.start),
        ends->segment.end - scene.conditioned(truth.end);
    sum += error.dot(ends->cov.ldlt().solve(error));
  }
  EXPECT_NEAR(sum / kTrials, 6.0, test::chi_square_mean_band(6.0, kTrials));  // false alarm 1 %
}

TEST(Endpoints, AreEmptyBehindACameraAndAtInfinity) {
  const ConditionedScene scene;
  const auto observed =
      scene.observe(test::exact_pair(scene.scene, {{-3, 1, 2}, {4, 6, 7}})).base();
  const Segment3 above{{-3, 1, 1700}, {4, 6, 1700}};
  EXPECT_FALSE(endpoints({scene.line(above), kNoCovariance}, scene.frames.views[0], observed,
                         scene.frames.views));
  Vector6d at_infinity = Vector6d::Zero();
  at_infinity.tail<3>() = Eigen::Vector3d(0.6, 0.0, 0.8);
  EXPECT_FALSE(
      endpoints({at_infinity, kNoCovariance}, scene.frames.views[0], observed, scene.frames.views));
}

}  // namespace
}  // namespace ridgeline::reconstruct
