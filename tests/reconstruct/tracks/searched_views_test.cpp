// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/searched_views.h"

#include "tests/reconstruct/support/block_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

using ::testing::ElementsAre;
using MatchState = SearchedViews::MatchState;

TEST(SearchedViews, HasTheNearestViewsFirst) {
  const test::BlockScene block;
  const SearchedViews views(block.scene, {});
  EXPECT_THAT(views.others(0), ElementsAre(3, 4, 1, 2));
  EXPECT_THAT(views.others(2), ElementsAre(0, 3, 4, 1));
}

TEST(SearchedViews, EqualDistancesAreInTheOrderOfIds) {
  std::vector<test::BlockCamera> cameras = test::kStrip;
  cameras[2].centre_m = cameras[1].centre_m;  // the same distance in all digits
  test::BlockScene block(cameras);
  EXPECT_THAT(SearchedViews(block.scene, {}).others(0), ElementsAre(1, 2));
  block.scene.views[1].id = "strip3";
  EXPECT_THAT(SearchedViews(block.scene, {}).others(0), ElementsAre(2, 1));
}

TEST(SearchedViews, ShowsThePixelsOfTheImage) {
  const test::BlockScene block;
  const SearchedViews views(block.scene, {});
  constexpr double kSize_px = test::kBlockImage_px;
  EXPECT_TRUE(views.shows(0, {0.0, 0.0}));
  EXPECT_TRUE(views.shows(0, {kSize_px - 0.1, kSize_px - 0.1}));
  EXPECT_FALSE(views.shows(0, {-0.1, 5.0}));
  EXPECT_FALSE(views.shows(0, {5.0, -0.1}));
  EXPECT_FALSE(views.shows(0, {kSize_px, 5.0}));
  EXPECT_FALSE(views.shows(0, {5.0, kSize_px}));
}

TEST(SearchedViews, ShowsTheEndsOfASegmentAtTheirHeights) {
  constexpr double kTol_px = 1e-8;  // of pixels up to 4000 in double
  constexpr double kTol_m = 1e-9;
  test::BlockScene block;
  const Segment3 line{{-8.0, -6.0, 4.0}, {8.0, 6.0, 5.0}};
  block.add(line);
  const SearchedViews views(block.scene, {});
  for (std::size_t from = 0; from < views.size(); ++from) {
    const Segment3 x = views.object_segment({from, 0}, {line.start.z(), line.end.z()});
    EXPECT_LT((x.start - line.start).norm(), kTol_m);
    EXPECT_LT((x.end - line.end).norm(), kTol_m);
    for (std::size_t to = 0; to < views.size(); ++to) {
      const EndStretches ends = views.stretches({from, 0}, to);
      const Segment2& truth = views.line({to, 0}).segment;
      EXPECT_LT((ends[0].at(line.start.z()) - truth.start).norm(), kTol_px);
      EXPECT_LT((ends[1].at(line.end.z()) - truth.end).norm(), kTol_px);
    }
  }
}

TEST(SearchedViews, TellsMatchesByAppearanceInBothDirections) {
  test::BlockScene block;
  for (const double y : {0.0, 5.0, 10.0}) block.add({{-5.0, y, 0.0}, {5.0, y, 0.0}});
  const std::vector<MatchedPair> pairs{{{3, 1}, {{0, 2}}}};
  const SearchedViews views(block.scene, pairs);
  EXPECT_EQ(views.match_state({3, 0}, {1, 2}), MatchState::kMatched);
  EXPECT_EQ(views.match_state({1, 2}, {3, 0}), MatchState::kMatched);
  EXPECT_EQ(views.match_state({3, 0}, {1, 0}), MatchState::kMatchedElsewhere);
  EXPECT_EQ(views.match_state({3, 1}, {1, 2}), MatchState::kMatchedElsewhere);
  EXPECT_EQ(views.match_state({3, 1}, {1, 1}), MatchState::kUnknown);
  EXPECT_EQ(views.match_state({0, 0}, {1, 2}), MatchState::kUnknown);
}

}  // namespace
}  // namespace ridgeline::reconstruct
