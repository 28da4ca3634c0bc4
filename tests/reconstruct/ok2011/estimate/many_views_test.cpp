// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"
#include "tests/reconstruct/support/block_scene.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"
#include "tests/reconstruct/support/nees.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

const Segment3 kSeenByMany{{-6.0, -5.0, 4.0}, {6.0, 5.0, 5.0}};

/// The line that the first n views of the block show, with errors if there is `random`.
ReconstructedLine line_of_views(std::size_t n, const Segment3& truth, test::Random* random) {
  const std::vector<test::BlockCamera> cameras(test::kBlock.begin(),
                                               test::kBlock.begin() + static_cast<int>(n));
  const auto in_order = test::BlockScene(cameras).cameras();
  std::vector<std::vector<UncertainSegment2>> segments;
  std::vector<Track> tracks(1);
  const test::Noise noise = test::scaled({}, 0.3);
  for (std::size_t v = 0; v < n; ++v) {
    const Segment2 image = project(in_order[v], truth);
    segments.push_back(
        {random != nullptr ? test::noisy(image, noise, *random) : test::exact(image, noise)});
    tracks[0].seen.push_back({v, 0});
  }
  EstimationOptions options = test::direct_options();
  options.lines.line_covariance = LineCovariance::kCentroid;
  return reconstruct_lines({in_order, segments, tracks, {}}, options.lines).front();
}

TEST(ManyViews, RecoverALineWithoutNoise) {
  constexpr double kExact_m =
      1e-9;  // 800 m in double have 1e-13, and 1e-12 after the angle of the rays
  for (const std::size_t n : {3U, 5U}) {
    const ReconstructedLine line = line_of_views(n, kSeenByMany, nullptr);
    EXPECT_LT((test::segment_of(line).start - kSeenByMany.start).norm(), kExact_m) << n;
    EXPECT_LT((test::segment_of(line).end - kSeenByMany.end).norm(), kExact_m) << n;
  }
}

TEST(ManyViews, StateTheirErrors) {
  constexpr int kTrials = 300;
  test::Random random(203);
  for (const std::size_t n : {2U, 3U, 5U}) {
    double sum = 0.0;
    for (int trial = 0; trial < kTrials; ++trial)
      sum += test::nees(line_of_views(n, kSeenByMany, &random), kSeenByMany);
    EXPECT_NEAR(sum / kTrials, 4.0, test::chi_square_mean_band(4.0, kTrials)) << n;
  }
}

TEST(ManyViews, TheLargestAngleOfAllPairsMakesTheClass) {
  const Segment3 along_strip{{-6.0, 0.0, 5.0}, {6.0, 0.0, 5.0}};
  EXPECT_EQ(line_of_views(3, along_strip, nullptr).line_class, LineClass::kAligned);
  EXPECT_EQ(line_of_views(4, along_strip, nullptr).line_class, LineClass::kNotAligned);
}

}  // namespace
}  // namespace ridgeline::reconstruct
