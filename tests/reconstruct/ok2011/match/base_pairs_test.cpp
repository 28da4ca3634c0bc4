// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/match/base_pairs.h"

#include "reconstruct/geometry/segment_index.h"
#include "tests/support/random.h"

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

TEST(SegmentIndex, FindsAllSegmentsThatABruteForceSearchFinds) {
  test::Random random(3);
  std::vector<Segment2> segments;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d start(random.uniform(-50, 500), random.uniform(-50, 500));
    segments.push_back(
        {start, start + Eigen::Vector2d(random.uniform(-80, 80), random.uniform(-80, 80))});
  }
  const SegmentIndex index(segments);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector2d low(random.uniform(-100, 500), random.uniform(-100, 500));
    const Eigen::AlignedBox2d box(
        low, low + Eigen::Vector2d(random.uniform(0, 90), random.uniform(0, 90)));
    const std::vector<int> found = index.in_box(box);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (std::size_t i = 0; i < segments.size(); ++i) {
      bool inside = false;
      for (double t = 0.0; t <= 1.0; t += 0.01) {
        inside = inside || box.contains((1.0 - t) * segments[i].start + t * segments[i].end);
      }
      if (!inside) continue;
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), static_cast<int>(i)));
    }
  }
}

TEST(SegmentIndex, OfNothingFindsNothing) {
  const SegmentIndex index({});
  EXPECT_THAT(index.in_box(Eigen::AlignedBox2d(Eigen::Vector2d(0, 0), Eigen::Vector2d(9, 9))),
              IsEmpty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
