// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/artificial_point.h"

#include "tests/reconstruct/support/conditioned_scene.h"
#include "tests/reconstruct/support/finite_difference.h"
#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::ConditionedScene;

constexpr double kSigmaPx = 0.3;

/// Both cameras of the scene and a third one between them, off the base.
std::array<ConditionedView, 3> three_views(const ConditionedScene& scene) {
  const ConditionedView& left = scene.frames.views[0];
  const ProjectionMatrix& p = scene.scene.cameras[0];
  const Eigen::Vector3d shift(100, 90, 20);
  ProjectionMatrix moved = p;
  moved.col(3) -= p.leftCols<3>() * shift;
  ImageConditioning image = left.image;
  image.centre_px = project(moved, Eigen::Vector3d(0, 0, 2));
  return {left, scene.frames.views[1],
          ConditionedView{conditioned_camera(moved, image, scene.frames.object), image}};
}

/// The point's image in each view, with independent errors of kSigmaPx, or none without `random`.
std::vector<ViewedPoint> observe_point(std::span<const ConditionedView> views,
                                       const Eigen::Vector3d& conditioned,
                                       test::Random* random) {
  std::vector<ViewedPoint> observations;
  for (const ConditionedView& view : views) {
    const double sigma = kSigmaPx / view.image.scale_px;
    Eigen::Vector2d x = project(view.image_from_object, conditioned);
    if (random != nullptr) {
      x.x() += random->normal(sigma);
      x.y() += random->normal(sigma);
    }
    UncertainPoint2 point{x.homogeneous(), Eigen::Matrix3d::Zero()};
    point.cov.topLeftCorner<2, 2>() = sigma * sigma * Eigen::Matrix2d::Identity();
    observations.push_back({view.image_from_object, spherically_normalised(point)});
  }
  return observations;
}

TEST(EstimatePoint, RecoversAPointWithoutNoise) {
  constexpr double kTolM = 1e-6;
  constexpr double kTolPx = 1e-8;
  const ConditionedScene scene;
  test::Random random(111);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector3d truth = random.vector(-20, 20);
    const auto observations = observe_point(scene.frames.views, scene.conditioned(truth), nullptr);
    const auto estimated = estimate_point(observations);
    ASSERT_TRUE(estimated);
    const Eigen::Vector3d x = estimated->point.mean.hnormalized();
    EXPECT_LT((scene.frames.object.local_from_conditioned(x) - truth).norm(), kTolM);
    EXPECT_LT(estimated->omega, 1e-12);
    for (std::size_t j = 0; j < 2; ++j) {
      const ConditionedView& view = scene.frames.views[j];
      const Eigen::Vector2d residual =
          project(view.image_from_object, x) - observations[j].point.mean.hnormalized();
      EXPECT_LT(view.image.scale_px * residual.norm(), kTolPx);
    }
  }
}

TEST(EstimatePoint, HasTheCovarianceOfItsDifferentialByTheObservations) {
  const ConditionedScene scene;
  const Eigen::Vector3d truth = scene.conditioned({5, -7, 3});
  auto observations = observe_point(scene.frames.views, truth, nullptr);
  const auto estimated = estimate_point(observations);
  ASSERT_TRUE(estimated);
  Eigen::Matrix4d expected = Eigen::Matrix4d::Zero();
  for (std::size_t j = 0; j < 2; ++j) {
    const auto by_image = [&](const Eigen::Vector3d& x) {
      auto changed = observations;
      changed[j].point.mean = x;
      const Eigen::Vector4d point = estimate_point(changed)->point.mean;
      return Eigen::Vector4d(point.dot(estimated->point.mean) < 0.0 ? -point : point);
    };
    const Eigen::Matrix<double, 4, 3> jacobian =
        test::central_differences<4, 3>(by_image, observations[j].point.mean);
    expected += jacobian * observations[j].point.cov * jacobian.transpose();
  }
  EXPECT_LT((estimated->point.cov - expected).norm(), 1e-6 * expected.norm());
}

TEST(EstimatePoint, HasTheStatedErrorsAndOmega) {
  constexpr int kTrials = 1000;
  const ConditionedScene scene;
  const std::array<ConditionedView, 3> views = three_views(scene);
  test::Random random(112);
  for (const std::size_t num_images : {std::size_t{2}, std::size_t{3}}) {
    double sum_nees = 0.0;
    double sum_omega = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const Eigen::Vector4d truth = scene.conditioned(random.vector(-15, 15)).homogeneous();
      const Eigen::Vector4d unit = truth.normalized();
      const auto estimated = estimate_point(
          observe_point(std::span(views).first(num_images), truth.hnormalized(), &random));
      ASSERT_TRUE(estimated);
      sum_nees += test::nees(estimated->point, unit, tangent_basis<4>(unit));
      sum_omega += estimated->omega;
    }
    // false alarm 1 % each
    const double redundancy = 2.0 * static_cast<double>(num_images) - 3.0;
    EXPECT_NEAR(sum_nees / kTrials, 3.0, test::chi_square_mean_band(3.0, kTrials));
    EXPECT_NEAR(sum_omega / kTrials, redundancy, test::chi_square_mean_band(redundancy, kTrials));
  }
}

TEST(EstimatePoint, CovarianceHasThePointAsNullVector) {
  const ConditionedScene scene;
  test::Random random(113);
  const auto estimated =
      estimate_point(observe_point(scene.frames.views, scene.conditioned({5, -7, 3}), &random));
  ASSERT_TRUE(estimated);
  const UncertainPoint3& x = estimated->point;
  EXPECT_NEAR(x.mean.norm(), 1.0, 1e-12);
  EXPECT_LT((x.cov * x.mean).norm(), 1e-6 * x.cov.norm());
}

TEST(EstimatePoint, OmegaGrowsWithTheDistanceFromTheEpipolarLine) {
  const ConditionedScene scene;
  auto observations = observe_point(scene.frames.views, scene.conditioned({5, -7, 3}), nullptr);
  const ConditionedView& right = scene.frames.views[1];
  const double offset = 3.0 * kSigmaPx / right.image.scale_px;
  const Eigen::Vector2d x = observations[1].point.mean.hnormalized();
  // the epipolar lines run along x within a few degrees
  observations[1].point.mean = Eigen::Vector3d(x.x(), x.y() + offset, 1.0).normalized();
  const auto estimated = estimate_point(observations);
  ASSERT_TRUE(estimated);
  // both points move by half: sigma of the parallax is sqrt(2) of a point's
  EXPECT_NEAR(estimated->omega, 9.0 / 2.0, 0.05);
}

TEST(EstimatePoint, IsEmptyWithoutABase) {
  const ConditionedScene scene;
  const std::array same{scene.frames.views[0], scene.frames.views[0]};
  EXPECT_FALSE(estimate_point(observe_point(same, scene.conditioned({5, -7, 3}), nullptr)));
}

TEST(EstimatePoint, RejectsASingleImage) {
  const ConditionedScene scene;
  const std::array one{scene.frames.views[0]};
  EXPECT_THROW(estimate_point(observe_point(one, scene.conditioned({5, -7, 3}), nullptr)),
               std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
