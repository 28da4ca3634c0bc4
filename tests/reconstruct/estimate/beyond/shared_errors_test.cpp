// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/shared_errors.h"

#include "reconstruct/estimate/tracked_lines.h"
#include "tests/reconstruct/support/block_scene.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"
#include "tests/reconstruct/support/nees.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

using test::covariance_of;
using test::segment_of;

constexpr int kTrials = 4000;
constexpr double kSharedShift_px = 0.1;
constexpr double kSharedTurn_px = 0.03;

/// Both images of a line with the same shift and turn, and each with errors of its own.
std::array<UncertainSegment2, 2> observed(const test::StereoScene& scene,
                                          const Segment3& truth,
                                          const test::Noise& own,
                                          test::Random& random) {
  const double shift_px = random.normal(kSharedShift_px);
  const double turn_px = random.normal(kSharedTurn_px);
  std::array<UncertainSegment2, 2> segments;
  for (const std::size_t j : {0U, 1U}) {
    Segment2 seen = project(scene.cameras[j], truth);
    const Eigen::Vector2d across = normal(seen);
    seen.start += (shift_px + turn_px) * across;
    seen.end += (shift_px - turn_px) * across;
    segments[j] = test::noisy(seen, own, random);
  }
  return segments;
}

TEST(SharedErrors, CovarianceHoldsForErrorsThatBothImagesShare) {
  const test::Noise own{0.03, 0.001, 1.0};
  EstimationOptions options = test::direct_options();
  options.lines.line_covariance = LineCovariance::kCentroid;  // exact for the noise drawn here
  test::Random random(7);
  for (const double angle_deg : {30.0, 60.0, 90.0}) {
    double sum = 0.0, sum_without = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      test::LineGroup group;
      group.truth = {test::make_segment(group.scene, test::line_at(angle_deg))};
      const auto seen = observed(group.scene, group.truth[0], own, random);
      group.segments = {{seen[0]}, {seen[1]}};
      group.matches = {{0, 0}};
      ReconstructedLine line = group.reconstruct(options)[0];
      sum_without += test::nees(line, group.truth[0]);
      add_shared_error(group.scene.cameras[0], line);
      sum += test::nees(line, group.truth[0]);
    }
    constexpr double kFreedom = 4.0;
    EXPECT_NEAR(sum / kTrials, kFreedom, test::chi_square_mean_band(kFreedom, kTrials));
    EXPECT_GT(sum_without / kTrials, 1.5 * kFreedom);
  }
}

TEST(SharedErrors, SharedErrorIsAcrossTheRaysAndTheLine) {
  test::LineGroup group = test::make_group(test::line_at(60.0), {});
  ReconstructedLine line = group.reconstruct(test::direct_options())[0];
  const Matrix6d before = covariance_of(line);
  add_shared_error(group.scene.cameras[0], line);
  const Eigen::Matrix3d added = (covariance_of(line) - before).topLeftCorner<3, 3>();
  const Segment3& segment = segment_of(line);
  const Eigen::Vector3d ray =
      (segment.start - projection_centre(group.scene.cameras[0]).hnormalized()).normalized();
  const Eigen::Vector3d along = (segment.end - segment.start).normalized();
  const double variance_m2 = added.trace();
  constexpr double kNone = 1e-9;
  EXPECT_LT((added * ray).norm(), kNone * variance_m2);
  EXPECT_LT((added * along).norm(), kNone * variance_m2);
  // seen from 800 m with a focal length of 10,000 px
  EXPECT_NEAR(std::sqrt(variance_m2), 0.08 * std::hypot(kSharedShift_px, kSharedTurn_px), 5e-4);
}

TEST(SharedErrors, LineWithoutCovarianceStaysWithout) {
  ReconstructedLine line;
  add_shared_error(test::StereoScene().cameras[0], line);
  EXPECT_FALSE(line.covariance_m2);
}

TEST(OwnSigmaScale, IsSmallForEqualProfilesAndGrowsWithTheirDifference) {
  constexpr double kExact = 1e-12;
  EXPECT_NEAR(own_sigma_scale(1.0), std::sqrt(0.1), kExact);
  EXPECT_NEAR(own_sigma_scale(0.98), std::sqrt(3.1), kExact);
  double last = own_sigma_scale(1.0);
  for (const double similarity : {0.999, 0.98, 0.9, 0.5, 0.0, -1.0}) {
    EXPECT_GT(own_sigma_scale(similarity), last);
    last = own_sigma_scale(similarity);
  }
  EXPECT_LT(last, std::sqrt(6.1));
}

/// What the first n views of the block show of a line. Its errors are `errors` times the stated
/// ones.
ObservedTrack seen_by(std::size_t n, double errors, test::Random& random) {
  const Segment3 truth{{-6.0, -5.0, 4.0}, {6.0, 5.0, 5.0}};
  const auto first = test::kBlock.begin();
  const auto cameras = test::BlockScene({first, first + static_cast<std::ptrdiff_t>(n)}).cameras();
  const test::Noise stated = test::scaled({}, 0.3);
  std::vector<std::vector<UncertainSegment2>> segments(n);
  std::vector<Track> tracks(1);
  for (std::size_t v = 0; v < n; ++v) {
    const Segment2 image = project(cameras[v], truth);
    UncertainSegment2 seen = test::noisy(image, test::scaled(stated, errors), random);
    seen.sigma_q_px = stated.q_px;
    seen.sigma_phi_rad = stated.phi_rad;
    segments[v] = {seen};
    tracks[0].observations.push_back({v, 0});
  }
  const TrackedSegments tracked{cameras, segments, tracks, {}};
  return tracked_lines(tracked, extracted(tracked), LineCovariance::kCentroid).lines[0];
}

double mean_squared_scale(double errors) {
  constexpr int kLines = 1000;
  test::Random random(31);
  double sum = 0.0;
  for (int i = 0; i < kLines; ++i)
    sum += std::pow(agreement_sigma_scale(seen_by(5, errors, random)), 2);
  return sum / kLines;
}

TEST(Agreement, OfTwoViewsSaysNothing) {
  test::Random random(30);
  EXPECT_EQ(agreement_sigma_scale(seen_by(2, 3.0, random)), 1.0);
}

TEST(Agreement, WithoutErrorsLeavesThePrior) {
  constexpr double kRounding = 1e-9;
  test::Random random(30);
  EXPECT_NEAR(agreement_sigma_scale(seen_by(3, 0.0, random)), std::sqrt(4.0 / 6.0), kRounding);
  EXPECT_NEAR(agreement_sigma_scale(seen_by(5, 0.0, random)), std::sqrt(4.0 / 10.0), kRounding);
}

TEST(Agreement, FollowsTheErrorsThatTheViewsHave) {
  // Omega has 6 degrees of freedom and mean 6 errors^2; the mean of 1000 of them is good to 0.02
  // errors^2.
  constexpr double kTolerance = 0.06;
  for (const double errors : {0.5, 1.0, 2.0}) {
    const double expected = (4.0 + 6.0 * errors * errors) / 10.0;
    EXPECT_NEAR(mean_squared_scale(errors) / expected, 1.0, kTolerance) << errors;
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
