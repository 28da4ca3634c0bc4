// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/epipolar_overlap.h"

#include "tests/reconstruct/match/ok2011/stereo_pair.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

using test::StereoPair;

constexpr double kExact_px = 1e-6;  // rounding at coordinates of some thousand pixels
/// Heights follow from parallaxes of 3.25 px/m.
constexpr double kExact_m = 1e-6;
/// Linear interpolation within a segment neglects the perspective: 1e-3 of its length here.
constexpr double kPerspective = 2e-3;

TEST(EpipolarTransfer, FindsTheHeightOfAPoint) {
  for (const double kappa_rad : {0.0, 0.3, M_PI_2, 2.5}) {
    const StereoPair pair(kappa_rad);
    const StereoSearch search = pair.search();
    const Eigen::Vector3d x(7.0, -4.0, 12.0);
    const Stretch stretch = search.right_from_left.stretch(project(pair.left, x));
    EXPECT_LT((stretch.at(12.0) - project(pair.right, x)).norm(), kExact_px) << kappa_rad;
    const Eigen::Vector2d along = stretch.derivative(12.0).normalized();
    EXPECT_NEAR(stretch.height_on(along, along.dot(project(pair.right, x))), 12.0, kExact_m);
  }
}

TEST(EpipolarTransfer, MovesPointsByTheParallaxOfTheirHeight) {
  const StereoPair pair;
  const Stretch stretch = pair.search().right_from_left.stretch({0.0, 0.0});
  // x_right - x_left = f B / H - f B / (H - z)
  const double expected = 10000.0 * 208.0 * (1.0 / 800.0 - 1.0 / 790.0);
  EXPECT_LT((stretch.at(10.0) - Eigen::Vector2d(expected, 0.0)).norm(), kExact_px);
}

TEST(LocalTransfer, IsTheIdentityForVerticalFramesOfOneHeight) {
  const StereoPair pair;
  const LocalTransfer local = local_transfer(pair.search().right_from_left, {30.0, 40.0}, 0.0);
  EXPECT_TRUE(local.jacobian.isIdentity(1e-9));
  EXPECT_NEAR(local.gsd_m, 0.08, 1e-9);
  EXPECT_NEAR(local.per_height.x(), -3.25, 1e-6);  // f B / H^2
}

TEST(StereoSearch, RejectsHeightsAndMatricesThatCannotBe) {
  StereoPair pair;
  pair.heights_m = {10.0, 10.0};
  EXPECT_THROW((void)pair.search(), std::invalid_argument);
  pair = StereoPair();
  pair.heights_m[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)pair.search(), std::invalid_argument);
  pair = StereoPair();
  pair.left(0, 0) = std::nan("");
  EXPECT_THROW((void)pair.search(), std::invalid_argument);
}

TEST(SearchedSegment, HasNoAnswerBehindTheCamera) {
  StereoPair pair;
  pair.heights_m = {700.0, 900.0};  // the camera is at 800 m
  EXPECT_FALSE(searched_segment(pair.search(), {{0.0, 0.0}, {10.0, 10.0}}).has_value());
}

TEST(EpipolarOverlap, TransfersTheEndsOfAnInclinedLine) {
  test::Random random(5);
  for (const double kappa_rad : {0.0, 0.7, -1.9}) {
    const StereoPair pair(kappa_rad);
    const StereoSearch search = pair.search();
    for (int trial = 0; trial < 200; ++trial) {
      const auto uniform = [&](double low, double high) { return random.uniform(low, high); };
      const double azimuth = uniform(0.3, M_PI - 0.3);  // clear of the epipolar direction
      const Eigen::Vector3d start(uniform(-20, 20), uniform(-20, 20), uniform(0, 20));
      const Eigen::Vector3d run(4.0 * std::cos(azimuth), 4.0 * std::sin(azimuth), uniform(-3, 3));
      const Segment3 line{start, start + run};
      // the right image shows the second half and runs the other way
      const Segment2 left = project(pair.left, line);
      const Segment2 right = project(pair.right, Segment3{start + run, start + 0.5 * run});
      const auto searched = searched_segment(search, left);
      ASSERT_TRUE(searched.has_value());
      ASSERT_FALSE(is_near_aligned(*searched, right, 0.08));
      const auto overlap = epipolar_overlap(*searched, right);
      ASSERT_TRUE(overlap.has_value());
      EXPECT_TRUE(overlap->reversed());
      EXPECT_NEAR(overlap->on_left[0], 0.5, kPerspective);
      EXPECT_NEAR(overlap->on_left[1], 1.0, kPerspective);
      EXPECT_NEAR(overlap->on_right[0], 1.0, kPerspective);
      EXPECT_NEAR(overlap->on_right[1], 0.0, kPerspective);
      EXPECT_NEAR(overlap->height_at(1.0), line.end.z(), 1e-2);
      EXPECT_NEAR(overlap->height_at(0.0), line.start.z(), 1e-2);
    }
  }
}

TEST(EpipolarOverlap, IsEmptyForSegmentsOfOtherRows) {
  const StereoPair pair;
  const auto searched = searched_segment(pair.search(), {{0.0, 0.0}, {5.0, 20.0}});
  EXPECT_FALSE(epipolar_overlap(*searched, {{0.0, 30.0}, {5.0, 50.0}}).has_value());
}

TEST(AlignedOverlaps, HoldTheTrueHeightOfALevelLine) {
  const StereoPair pair;
  const Segment3 line{{0.0, 0.0, 8.0}, {4.0, 0.0, 8.0}};
  const auto searched = searched_segment(pair.search(), project(pair.left, line));
  const Segment2 right = project(pair.right, line);
  ASSERT_TRUE(is_near_aligned(*searched, right, 0.08));
  const auto overlaps = aligned_overlaps(*searched, right, pair.heights_m, 2.0, 1.0);
  ASSERT_FALSE(overlaps.empty());
  const auto nearest = std::min_element(
      overlaps.begin(), overlaps.end(), [](const EpipolarOverlap& a, const EpipolarOverlap& b) {
        return std::abs(a.height_at(0.5) - 8.0) < std::abs(b.height_at(0.5) - 8.0);
      });
  EXPECT_LT(std::abs(nearest->height_at(0.5) - 8.0), 1.0 / 3.25);  // one step of 1 px
  EXPECT_NEAR(overlaps.back().height_at(0.0), 8.0, 1e-3);          // the one that matches both ends
  EXPECT_NEAR(overlaps.back().height_at(1.0), 8.0, 1e-3);
  for (const EpipolarOverlap& overlap : overlaps) EXPECT_TRUE(overlap.aligned);
}

TEST(AlignedOverlaps, AreEmptyBesideTheEpipolarBand) {
  const StereoPair pair;
  const Segment3 line{{0.0, 0.0, 8.0}, {4.0, 0.0, 8.0}};
  const auto searched = searched_segment(pair.search(), project(pair.left, line));
  Segment2 right = project(pair.right, line);
  right.start.y() += 5.0;
  right.end.y() += 5.0;
  EXPECT_TRUE(aligned_overlaps(*searched, right, pair.heights_m, 2.0, 1.0).empty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
