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
  EXPECT_THAT(base_pairs(segments), ElementsAre(BasePair{0, 1}, BasePair{1, 2}));
}

TEST(BasePairs, NeedTheIntersectionNearBothSegments) {
  // at 11.3 degrees the lines meet 5.1 times as far before the second segment as they are apart
  const auto pairs_apart = [](double y_px) {
    return base_pairs(std::vector<Segment2>{{{0, 0}, {40, 0}}, {{0, y_px}, {50, y_px + 10}}});
  };
  EXPECT_THAT(pairs_apart(29.0), ElementsAre(BasePair{0, 1}));  // 148 px
  EXPECT_THAT(pairs_apart(30.0), IsEmpty());                    // 153 px
}

TEST(BasePairs, WidenTheRadiusForIsolatedSegments) {
  const auto pairs_apart = [](double x_px) {
    return base_pairs(
        std::vector<Segment2>{{{0, 0}, {40, 0}}, {{40 + x_px, -20}, {40 + x_px, 20}}});
  };
  EXPECT_THAT(pairs_apart(145.0), ElementsAre(BasePair{0, 1}));
  EXPECT_THAT(pairs_apart(155.0), IsEmpty());
}

TEST(BasePairs, KeepTheNearestOfMany) {
  // uprights at growing distances from the first segment, the nearest one last
  constexpr int kUprights = 20;
  std::vector<Segment2> segments = {{{0, 0}, {500, 0}}};
  for (int i = 0; i < kUprights; ++i) {
    const double x = 10.0 + 24.0 * i;
    const double below = 2.0 + (kUprights - 1 - i);
    segments.push_back({{x, below}, {x, below + 18.0}});
  }
  // ticks across each upright: nearer partners of it than the first segment
  for (int i = 1; i <= kUprights; ++i) {
    for (int along = 1; along <= 16; ++along) {
      const Eigen::Vector2d x = segments[i].start + Eigen::Vector2d(0.0, along);
      segments.push_back({x - Eigen::Vector2d(3.0, 0.0), x + Eigen::Vector2d(3.0, 0.0)});
    }
  }
  std::vector<int> with_first;
  for (const BasePair& pair : base_pairs(segments)) {
    if (pair.first == 0) with_first.push_back(pair.second);
  }
  EXPECT_THAT(with_first, ElementsAre(6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20));
}

}  // namespace
}  // namespace ridgeline::reconstruct
