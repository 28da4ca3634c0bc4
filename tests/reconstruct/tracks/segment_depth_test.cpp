// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/segment_depth.h"

#include "tests/reconstruct/support/block_scene.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::BlockScene;

constexpr double kHeight_m = 1e-6;  // doubles of rays of 800 m leave about 1e-9

bool all_free(const Observation& /*observation*/) { return true; }

std::optional<ProposedTrack> proposed(const BlockScene& block,
                                      const Observation& reference,
                                      const std::vector<MatchedPair>& pairs = {},
                                      const IsFree& is_free = all_free) {
  const SearchedViews views(block.scene, pairs);
  return propose_track(views, reference, {}, {}, is_free);
}

TEST(ProposeTrack, HasTheHeightsOfTheLine) {
  const BlockScene block = test::block_of_lines();
  for (std::size_t v = 0; v < block.scene.views.size(); ++v) {
    for (std::size_t s = 0; s < block.line_of[v].size(); ++s) {
      const Observation reference{v, static_cast<int>(s)};
      const auto track = proposed(block, reference);
      ASSERT_TRUE(track) << v << " " << s;
      EXPECT_EQ(track->base(), reference);
      const Segment3& truth = block.lines[static_cast<std::size_t>(block.line_at(reference))];
      EXPECT_NEAR(track->depth.heights_m[0], truth.start.z(), kHeight_m) << v << " " << s;
      EXPECT_NEAR(track->depth.heights_m[1], truth.end.z(), kHeight_m) << v << " " << s;
    }
  }
}

TEST(ProposeTrack, IsMoreCertainWithMoreViews) {
  const Segment3 line{{-5.0, -3.0, 4.0}, {5.0, 4.0, 5.0}};
  BlockScene of_three({test::kBlock[0], test::kBlock[1], test::kBlock[3]});
  of_three.add(line);
  BlockScene of_five;
  of_five.add(line);
  const auto three = proposed(of_three, {0, 0});
  const auto five = proposed(of_five, {0, 0});
  ASSERT_TRUE(three && five);
  EXPECT_LT(five->depth.cov_m2.trace(), three->depth.cov_m2.trace());
  EXPECT_LT(five->depth.cov_m2.determinant(), three->depth.cov_m2.determinant());
}

TEST(ProposeTrack, StatesTheErrorsOfItsHeights) {
  constexpr int kTrials = 200;
  // The error of the segment itself counts with each view as if it were new, so that the sum is
  // near 2, not equal.
  constexpr double kMinMean = 1.0;
  constexpr double kMaxMean = 3.0;
  constexpr int kMaxUndecidedTrials =
      5;  // each of four views may be beyond the 99.9 % limit of the others
  BlockScene exact;
  exact.add({{-5.0, -3.0, 4.0}, {5.0, 4.0, 4.0}});
  BlockScene block = exact;
  TrackOptions options;
  options.sigma_edge_px = 0.01;  // all views show the same edge
  test::Random random(205);
  test::Noise noise = test::scaled({}, 0.2);
  noise.e_px = 0.0;
  double sum = 0.0;
  int n_decided = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    for (std::size_t v = 0; v < block.scene.views.size(); ++v) {
      const Segment2& image = exact.scene.views[v].segments[0].line.segment;
      block.scene.views[v].segments[0].line = test::noisy(image, noise, random);
    }
    const SearchedViews views(block.scene, {});
    const auto track = propose_track(views, {0, 0}, {}, options, all_free);
    if (!track) continue;
    ++n_decided;
    const Eigen::Vector2d error = track->depth.heights_m - Eigen::Vector2d::Constant(4.0);
    sum += error.dot(track->depth.cov_m2.inverse() * error);
  }
  ASSERT_GE(n_decided, kTrials - kMaxUndecidedTrials);
  EXPECT_GT(sum / n_decided, kMinMean);
  EXPECT_LT(sum / n_decided, kMaxMean);
}

TEST(ProposeTrack, AViewThatShouldShowTheLineAndDoesNotLowersTheOdds) {
  const Segment3 line{{-5.0, -3.0, 4.0}, {5.0, 4.0, 5.0}};
  BlockScene hidden;
  hidden.add(line, {4});
  BlockScene outside = hidden;
  outside.scene.views[4].image = cv::Mat(10, 10, CV_32F);  // the line is not in the image
  const auto with_hidden = proposed(hidden, {0, 0});
  const auto with_outside = proposed(outside, {0, 0});
  ASSERT_TRUE(with_hidden && with_outside);
  constexpr double kOdds = 1e-9;  // rounding of a sum of logarithms
  EXPECT_NEAR(with_hidden->log_odds, with_outside->log_odds + std::log(1.0 - kSeenShare), kOdds);
}

TEST(ProposeTrack, LeavesOutTheSegmentThatAllOtherViewsContradict) {
  // View 1 alone does not predict sharply enough to tell; a hypothesis that begins with a view
  // across the strip does.
  constexpr double kBeside_m = 0.16;  // 1.6 px
  const Segment3 line{{-5.0, -3.0, 4.0}, {5.0, 4.0, 5.0}};
  BlockScene block;
  block.add(line, {2});
  const Eigen::Vector3d beside_m(0.0, kBeside_m, 0.0);
  block.lines.push_back({line.start + beside_m, line.end + beside_m});
  block.show(2, 1, 0.0, 1.0);
  const auto track = proposed(block, {0, 0});
  ASSERT_TRUE(track);
  EXPECT_TRUE(
      std::ranges::none_of(track->observations, [](const Observation& s) { return s.view == 2; }));
  EXPECT_NEAR(track->depth.heights_m[0], line.start.z(), kHeight_m);
  EXPECT_NEAR(track->depth.heights_m[1], line.end.z(), kHeight_m);
}

TEST(ProposeTrack, ParallelSegmentsBesideTheLineLowerTheOddsByTheirDensity) {
  const Segment3 line{{-5.0, -3.0, 4.0}, {5.0, 4.0, 5.0}};
  BlockScene lone;
  lone.add(line);
  BlockScene crowded = lone;
  for (const double beside_m : {-0.8, 0.8}) {  // 7 px across, which is no observation
    const Eigen::Vector3d by_m(0.0, beside_m, 0.0);
    crowded.lines.push_back({line.start + by_m, line.end + by_m});
    crowded.show(3, static_cast<int>(crowded.lines.size()) - 1, 0.0, 1.0);
  }
  const auto among_none = proposed(lone, {0, 0});
  const auto among_two = proposed(crowded, {0, 0});
  ASSERT_TRUE(among_none && among_two);
  EXPECT_EQ(among_none->observations, among_two->observations);
  constexpr double kLess = 0.1;  // the share 1 - kSeenShare = 0.3 beside odds of 3 and more
  EXPECT_NEAR(among_none->log_odds - among_two->log_odds, std::log(3.5 / 1.5), kLess);
}

TEST(ProposeTrack, OfTwoViewsIsNothing) {
  BlockScene block;
  block.add({{-5.0, -3.0, 4.0}, {5.0, 4.0, 5.0}}, {2, 3, 4});
  EXPECT_FALSE(proposed(block, {0, 0}));
}

TEST(ProposeTrack, TakesFreeSegmentsAlone) {
  BlockScene block;
  block.add({{-5.0, -3.0, 4.0}, {5.0, 4.0, 5.0}});
  const auto track = proposed(block, {0, 0}, {}, [](const Observation& s) { return s.view != 3; });
  ASSERT_TRUE(track);
  EXPECT_EQ(track->observations.size(), 4);
  EXPECT_TRUE(
      std::ranges::none_of(track->observations, [](const Observation& s) { return s.view == 3; }));
}

TEST(ProposeTrack, IsNothingOutsideTheHeightsOrForAWall) {
  BlockScene block;
  block.add({{-5.0, -3.0, 30.0}, {5.0, 4.0, 30.0}});  // above the range
  EXPECT_FALSE(proposed(block, {0, 0}));
  BlockScene wall;
  wall.add({{20.0, 30.0, 0.0}, {21.0, 31.0, 8.0}});  // 80 degrees
  EXPECT_FALSE(proposed(wall, {0, 0}));
}

TEST(ProposeTrack, AMatchByItsAppearanceRaisesTheOdds) {
  BlockScene block;
  block.add({{-5.0, -3.0, 4.0}, {5.0, 4.0, 5.0}});
  block.add({{-5.0, 97.0, 4.0}, {5.0, 104.0, 5.0}}, {1, 2, 3, 4});
  block.add({{-5.0, 97.0, 4.0}, {5.0, 104.0, 5.0}}, {0, 2, 3, 4});
  const auto plain = proposed(block, {0, 0});
  const auto matched = proposed(block, {0, 0}, {{{0, 1}, {{0, 0}}}});
  const auto elsewhere = proposed(block, {0, 0}, {{{0, 1}, {{0, 1}}}});
  ASSERT_TRUE(plain && matched && elsewhere);
  EXPECT_GT(matched->log_odds, plain->log_odds);
  EXPECT_LT(elsewhere->log_odds, plain->log_odds);
}

TEST(AddPieces, AddsThoseOnTheLineWithinItsPart) {
  BlockScene block;
  const int line = block.add({{-8.0, -6.0, 4.0}, {8.0, 6.0, 5.0}}, {1});
  block.show(1, line, 0.1, 0.6);  // 0: found by the proposal
  block.show(1, line, 0.7, 0.9);  // 1: a piece
  block.show(1, line, 0.3, 0.5);  // 2: covers what 0 does
  block.show(1, line, 1.2, 1.5);  // 3: beyond what any view shows
  block.lines.push_back({{-8.0, -6.5, 4.0}, {8.0, 5.5, 5.0}});
  block.show(1, line + 1, 0.7, 0.9);  // 4: 4 px beside
  const SearchedViews views(block.scene, {});
  auto track = propose_track(views, {0, 0}, {}, {},
                             [](const Observation& s) { return s.view != 1 || s.segment == 0; });
  ASSERT_TRUE(track);
  const auto of_view_1 = [&] {
    std::vector<int> all;
    for (const Observation& s : track->observations) {
      if (s.view == 1) all.push_back(s.segment);
    }
    return all;
  };
  ASSERT_EQ(of_view_1(), (std::vector<int>{0}));
  add_pieces(
      views, {}, [](const Observation& s) { return s.segment != 1; }, *track);
  EXPECT_EQ(of_view_1(), (std::vector<int>{0}));
  add_pieces(views, {}, all_free, *track);
  EXPECT_EQ(of_view_1(), (std::vector<int>{0, 1}));
}

}  // namespace
}  // namespace ridgeline::reconstruct
