// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/segment_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace ridgeline::evaluate {
namespace {

std::vector<Segment3> random_segments(std::size_t n) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.0, 60.0);
  std::uniform_real_distribution<double> extent(-8.0, 8.0);
  std::vector<Segment3> segments;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d start(place(random), place(random), place(random));
    segments.push_back(
        {start, start + Eigen::Vector3d(extent(random), extent(random), extent(random))});
  }
  return segments;
}

bool boxes_within(const Segment3& a, const Segment3& b, double reach) {
  const Eigen::Array3d a_low = a.start.cwiseMin(a.end);
  const Eigen::Array3d a_high = a.start.cwiseMax(a.end);
  const Eigen::Array3d b_low = b.start.cwiseMin(b.end);
  const Eigen::Array3d b_high = b.start.cwiseMax(b.end);
  return (a_low <= b_high + reach).all() && (b_low <= a_high + reach).all();
}

TEST(SegmentTree, FindsWhatComparingAllFinds) {
  constexpr double kReach_m = 3.0;
  const std::vector<Segment3> segments = random_segments(300);
  const SegmentTree<Segment3> tree(segments);
  std::size_t n_found = 0;
  for (const Segment3& s : segments) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (boxes_within(s, segments[i], kReach_m)) expected.push_back(i);
    }
    EXPECT_EQ(tree.near(s, kReach_m), expected);
    n_found += expected.size();
  }
  EXPECT_GT(n_found, 2 * segments.size());  // others than itself
}

TEST(SegmentTree, ReachGrowsTheBoxAndNothingElse) {
  const std::vector<Segment2> segments{{{0, 0}, {10, 0}}, {{0, 5}, {10, 5}}};
  const SegmentTree<Segment2> tree(segments);
  EXPECT_EQ(tree.near({{2, 1}, {3, 1}}, 0.9), (std::vector<std::size_t>{}));
  EXPECT_EQ(tree.near({{2, 1}, {3, 1}}, 1.1), (std::vector<std::size_t>{0}));
  EXPECT_EQ(tree.near({{2, 1}, {3, 1}}, 4.1), (std::vector<std::size_t>{0, 1}));
}

TEST(SegmentTree, SegmentsThatAreNotFiniteAreNowhere) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Segment2> segments{
      {{kNan, 0}, {1, 0}}, {{0, 0}, {1, 0}}, {{0, 0}, {HUGE_VAL, 0}}};
  const SegmentTree<Segment2> tree(segments);
  EXPECT_EQ(tree.near({{0, 0}, {1, 1}}, 1e9), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(tree.near({{0, kNan}, {1, 1}}, 1e9).empty());
  EXPECT_TRUE(SegmentTree<Segment2>(std::span<const Segment2>()).near(segments[1], 1e9).empty());
}

}  // namespace
}  // namespace ridgeline::evaluate
