// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/base_pairs.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kTol_px = 1e-9;

TEST(Intersection, OfTwoLinesOutsideOfTheSegments) {
  const auto x = intersection({{0, 0}, {1, 0}}, {{5, 3}, {5, 1}}, 0.1);
  ASSERT_TRUE(x.has_value());
  EXPECT_LT((*x - Eigen::Vector2d(5.0, 0.0)).norm(), kTol_px);
}

TEST(Intersection, IsAbsentUpToTheSmallestAngle) {
  EXPECT_FALSE(intersection({{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, 0.0).has_value());
  EXPECT_FALSE(intersection({{0, 0}, {10, 0}}, {{0, 1}, {10, 2}}, 0.1).has_value());  // 0.0997
  EXPECT_TRUE(intersection({{0, 0}, {10, 0}}, {{0, 1}, {10, 2}}, 0.09).has_value());
}

TEST(BasePairs, JoinSegmentsThatMeetNearby) {
  // a corner, and a line that is parallel to its first side
  const std::vector<Segment2> segments = {
      {{0, 0}, {40, 0}}, {{41, 1}, {41, 30}}, {{0, 10}, {40, 10}}};
  EXPECT_THAT(base_pairs(segments, {}), ElementsAre(BasePair{0, 1}, BasePair{1, 2}));
}

TEST(BasePairs, NeedTheIntersectionNearBothSegments) {
  // 20 px apart at 11.3 degrees: the lines meet 100 px before the second segment
  const std::vector<Segment2> segments = {{{0, 0}, {40, 0}}, {{0, 20}, {50, 30}}};
  MatchOptions options;
  options.max_pair_radius_px = 90.0;
  EXPECT_THAT(base_pairs(segments, options), IsEmpty());
  options.max_pair_radius_px = 110.0;
  EXPECT_THAT(base_pairs(segments, options), ElementsAre(BasePair{0, 1}));
}

TEST(BasePairs, WidenTheRadiusForIsolatedSegments) {
  const std::vector<Segment2> segments = {{{0, 0}, {40, 0}}, {{140, -20}, {140, 20}}};
  EXPECT_THAT(base_pairs(segments, {}), ElementsAre(BasePair{0, 1}));  // 100 px
  MatchOptions narrow;
  narrow.max_pair_radius_px = 90.0;
  EXPECT_THAT(base_pairs(segments, narrow), IsEmpty());
}

TEST(BasePairs, KeepTheNearestOfMany) {
  // uprights at growing distances from the first segment, the nearest one last
  constexpr int kUprights = 8;
  std::vector<Segment2> segments = {{{0, 0}, {200, 0}}};
  for (int i = 0; i < kUprights; ++i) {
    const double x = 10.0 + 24.0 * i;
    const double below = 2.0 + (kUprights - 1 - i);
    segments.push_back({{x, below}, {x, below + 16.0}});
  }
  // four ticks across each upright: nearer partners of it than the first segment
  for (int i = 1; i <= kUprights; ++i) {
    for (const double along : {3.0, 6.0, 9.0, 12.0}) {
      const Eigen::Vector2d x = segments[i].start + Eigen::Vector2d(0.0, along);
      segments.push_back({x - Eigen::Vector2d(3.0, 0.0), x + Eigen::Vector2d(3.0, 0.0)});
    }
  }
  MatchOptions options;
  options.max_partners = 4;
  options.min_partners = 3;
  std::vector<int> with_first;
  for (const BasePair& pair : base_pairs(segments, options)) {
    if (pair.first == 0) with_first.push_back(pair.second);
  }
  EXPECT_THAT(with_first, ElementsAre(5, 6, 7, 8));
}

}  // namespace
}  // namespace ridgeline::reconstruct
