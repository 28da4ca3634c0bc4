// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/predicted_line.h"

#include "tests/reconstruct/support/block_scene.h"
#include "tests/reconstruct/support/finite_difference.h"

#include <gtest/gtest.h>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

const Segment3 kSloping{{-5.0, -3.0, 4.0}, {5.0, 4.0, 5.0}};
const Eigen::Vector2d kTrueHeights_m(4.0, 5.0);

/// What view `view` shows of the line of view 0 at these heights.
PredictionResidual observed(const SearchedViews& views,
                            std::size_t view,
                            const Eigen::Vector2d& heights_m,
                            const std::array<double, 2>& at = {0.0, 1.0}) {
  return residual_of(views.line({0, 0}), heights_m,
                     predict(views.stretches({0, 0}, view), heights_m), views.line({view, 0}), at,
                     0.3);
}

test::BlockScene scene_of_one_line() {
  test::BlockScene block;
  block.add(kSloping);
  return block;
}

TEST(ResidualOf, HasNoResidualAtTheTrueHeights) {
  constexpr double kRounding_px = 1e-8;  // doubles of 4000 px from 800 m
  const test::BlockScene block = scene_of_one_line();
  const SearchedViews views(block.scene, {});
  for (std::size_t v = 1; v < views.size(); ++v)
    EXPECT_LT(observed(views, v, kTrueHeights_m, {0.2, 0.7}).residual_px.norm(), kRounding_px);
}

TEST(ResidualOf, JacobianIsThatOfCentralDifferences) {
  constexpr double kRelative = 1e-6;  // of residuals of 4000 px by steps of 1e-6 m
  const test::BlockScene block = scene_of_one_line();
  const SearchedViews views(block.scene, {});
  const std::array at{0.2, 0.7};
  for (std::size_t v = 1; v < views.size(); ++v) {
    const Eigen::Matrix2d numeric = test::central_differences<2, 2>(
        [&](const Eigen::Vector2d& h) { return observed(views, v, h, at).residual_px; },
        Eigen::Vector2d(3.0, 7.0));
    const Eigen::Matrix2d analytic = observed(views, v, {3.0, 7.0}, at).by_heights;
    EXPECT_LT((analytic - numeric).norm(), kRelative * numeric.norm()) << v;
  }
}

TEST(DepthBy, IsTheTrueDepthFromPredictionsElsewhere) {
  // Within 1 m a prediction is linear in height but for about 1e-6 of its shift.
  constexpr double kLinear_m = 1e-3;
  const test::BlockScene block = scene_of_one_line();
  const SearchedViews views(block.scene, {});
  std::vector<PredictionResidual> all;
  for (std::size_t v = 1; v < views.size(); ++v) {
    all.push_back(observed(views, v, kTrueHeights_m + Eigen::Vector2d(0.5, -0.5)));
    EXPECT_LT((depth_by(all).heights_m - kTrueHeights_m).norm(), kLinear_m) << v;
  }
}

TEST(DepthBy, EveryObservationMakesTheDepthSharper) {
  const test::BlockScene block = scene_of_one_line();
  const SearchedViews views(block.scene, {});
  std::vector<PredictionResidual> all{observed(views, 1, kTrueHeights_m)};
  SegmentDepth before = depth_by(all);
  for (std::size_t v = 2; v < views.size(); ++v) {
    all.push_back(observed(views, v, kTrueHeights_m));
    const SegmentDepth now = depth_by(all);
    EXPECT_LT(now.cov_m2.determinant(), before.cov_m2.determinant()) << v;
    before = now;
  }
}

TEST(DepthBy, NothingIsNotFinite) { EXPECT_FALSE(depth_by({}).heights_m.allFinite()); }

}  // namespace
}  // namespace ridgeline::reconstruct
