// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "tests/reconstruct/support/block_scene.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"
#include "tests/reconstruct/support/nees.h"

#include <gtest/gtest.h>

#include <array>
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
    tracks[0].observations.push_back({v, 0});
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

TEST(ManyViews, EndWhereTwoOfThemShowTheLine) {
  constexpr double kExact_m =
      1e-8;  // rays of 800 m, cut by planes that hit the line at 60 degrees and more
  const std::array<std::array<double, 2>, 3> shown{{{0.0, 1.0}, {0.2, 0.9}, {0.1, 0.7}}};
  test::BlockScene block({test::kBlock[0], test::kBlock[1], test::kBlock[3]});
  block.lines.push_back(kSeenByMany);
  for (std::size_t v = 0; v < shown.size(); ++v) block.show(v, 0, shown[v][0], shown[v][1]);
  const std::vector<Track> tracks{{{{0, 0}, {1, 0}, {2, 0}}}};
  const auto cameras = block.cameras();
  const auto segments = transformed(
      block.scene.views, [](const View& view) { return std::vector{view.segments[0].line}; });
  const ReconstructedLine line =
      reconstruct_lines({cameras, segments, tracks, {}}, test::direct_options().lines).front();
  EXPECT_LT((test::segment_of(line).start - point_at(kSeenByMany, 0.1)).norm(), kExact_m);
  EXPECT_LT((test::segment_of(line).end - point_at(kSeenByMany, 0.9)).norm(), kExact_m);
}

/// An aligned line with a neighbour, which the first n views of a strip show.
ReconstructedLine aligned_line_of(std::size_t n) {
  const std::array<Segment3, 2> truth{Segment3{{-6.0, 0.0, 5.0}, {6.0, 0.0, 5.0}},
                                      Segment3{{-5.8, 0.1, 5.0}, {-5.5, 8.0, 2.0}}};
  const std::vector<test::BlockCamera> strip(test::kStrip.begin(),
                                             test::kStrip.begin() + static_cast<int>(n));
  const auto cameras = test::BlockScene(strip).cameras();
  const test::Noise noise = test::scaled({}, 0.3);
  std::vector<std::vector<UncertainSegment2>> segments(n);
  std::vector<Track> tracks(truth.size());
  for (std::size_t v = 0; v < n; ++v) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Segment2 image = project(cameras[v], truth[i]);
      segments[v].push_back(test::exact(image, noise));
      tracks[i].observations.push_back({v, static_cast<int>(i)});
    }
  }
  const std::vector<PairConnection> connections{{0, 1}};
  return reconstruct_lines({cameras, segments, tracks, connections}, test::published().lines)
      .front();
}

TEST(ManyViews, MakeOneArtificialPointThatIsSharperThanThatOfTwo) {
  const ReconstructedLine of_two = aligned_line_of(2);
  const ReconstructedLine of_three = aligned_line_of(3);
  ASSERT_EQ(of_two.line_class, LineClass::kAligned);
  ASSERT_EQ(of_three.line_class, LineClass::kAligned);
  ASSERT_EQ(of_two.points.size(), 1);
  ASSERT_EQ(of_three.points.size(), 1);
  EXPECT_LT(of_three.points[0].cov_m2(2, 2), of_two.points[0].cov_m2(2, 2));
}

TEST(ManyViews, TheLargestAngleOfAllPairsMakesTheClass) {
  const Segment3 along_strip{{-6.0, 0.0, 5.0}, {6.0, 0.0, 5.0}};
  EXPECT_EQ(line_of_views(3, along_strip, nullptr).line_class, LineClass::kAligned);
  EXPECT_EQ(line_of_views(4, along_strip, nullptr).line_class, LineClass::kNotAligned);
}

}  // namespace
}  // namespace ridgeline::reconstruct
