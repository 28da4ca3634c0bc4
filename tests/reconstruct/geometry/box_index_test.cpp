// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/box_index.h"

#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace ridgeline {
namespace {

using Box = Eigen::AlignedBox2d;

/// The places of the boxes within reach, by a look at all of them.
std::vector<std::size_t> expected(const std::vector<Box>& boxes, const Box& box, double reach) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < boxes.size(); ++k)
    if (!box.isEmpty() && !boxes[k].isEmpty() && boxes[k].exteriorDistance(box) <= reach)
      found.push_back(k);
  return found;
}

TEST(BoxIndex, FindsWhatASearchOfAllFinds) {
  test::Random random(3);
  std::vector<Box> boxes(1);  // an empty one
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d corner = random.vector(-100.0, 100.0).head<2>();
    boxes.emplace_back(corner, corner + random.vector(0.0, 40.0).head<2>());
  }
  const BoxIndex2 index(boxes);
  for (const Box& box : boxes) EXPECT_EQ(index.near(box, 3.0), expected(boxes, box, 3.0));
}

TEST(BoxIndex, TakesBoxesOfAnySizeAnywhere) {
  const auto box = [](double low, double high) {
    return Box(Eigen::Vector2d::Constant(low), Eigen::Vector2d::Constant(high));
  };
  const std::vector<Box> boxes{box(0, 1), box(-1e30, 1e30), box(1e20, 1e20), box(5, 5e6)};
  const BoxIndex2 index(boxes);
  for (const Box& asked : boxes) EXPECT_EQ(index.near(asked, 0.5), expected(boxes, asked, 0.5));
  EXPECT_EQ(index.near(box(-1e9, 1e9), 0.0), (std::vector<std::size_t>{0, 1, 3}));
}

TEST(BoxIndex, NeverFindsWhatIsNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Box endless(Eigen::Vector2d(0, 0), Eigen::Vector2d(kInfinity, 1));
  const BoxIndex2 index(std::vector<Box>{endless});
  EXPECT_TRUE(index.near(Box(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)), 1.0).empty());
  EXPECT_TRUE(index.near(endless, 1.0).empty());
  EXPECT_TRUE(plan_box_of(std::vector<Eigen::Vector3d>{{0, 0, 0}, {0, NAN, 0}}).isEmpty());
}

bool boxes_within(const Segment3& a, const Segment3& b, double reach) {
  const Eigen::AlignedBox3d box_a(a.start.cwiseMin(a.end), a.start.cwiseMax(a.end));
  const Eigen::AlignedBox3d box_b(b.start.cwiseMin(b.end), b.start.cwiseMax(b.end));
  return box_a.exteriorDistance(box_b) <= reach;
}

TEST(BoxIndex, FindsSegmentsByTheirBoxes) {
  constexpr double kReach_m = 3.0;
  test::Random random(5);
  std::vector<Segment3> segments;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d start = random.vector(0.0, 60.0);
    segments.push_back({start, start + random.vector(-8.0, 8.0)});
  }
  const BoxIndex3 index(segments);
  std::size_t n_found = 0;
  for (const Segment3& s : segments) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (boxes_within(s, segments[i], kReach_m)) expected.push_back(i);
    }
    EXPECT_EQ(index.near(s, kReach_m), expected);
    n_found += expected.size();
  }
  EXPECT_GT(n_found, 2 * segments.size());  // others than itself
}

TEST(BoxIndex, ReachIsADistanceInPixelsOrMetres) {
  const std::vector<Segment2> segments{{{0, 0}, {10, 0}}, {{0, 5}, {10, 5}}};
  const BoxIndex2 index(segments);
  EXPECT_TRUE(index.near(Segment2{{2, 1}, {3, 1}}, 0.9).empty());
  EXPECT_EQ(index.near(Segment2{{2, 1}, {3, 1}}, 1.1), (std::vector<std::size_t>{0}));
  EXPECT_EQ(index.near(Segment2{{2, 1}, {3, 1}}, 4.1), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(index.near(Segment2{{11, -1}, {12, -2}}, 1.2).empty());  // 1.4 from the corner
}

TEST(BoxIndex, SegmentsThatAreNotFiniteAreNowhere) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Segment2> segments{
      {{kNan, 0}, {1, 0}}, {{0, 0}, {1, 0}}, {{0, 0}, {HUGE_VAL, 0}}};
  const BoxIndex2 index(segments);
  EXPECT_EQ(index.near(Segment2{{0, 0}, {1, 1}}, 1e9), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(index.near(Segment2{{0, kNan}, {1, 1}}, 1e9).empty());
}

TEST(BoxIndex, OfNothingFindsNothing) {
  const Box box(Eigen::Vector2d(0, 0), Eigen::Vector2d(9, 9));
  EXPECT_TRUE(BoxIndex2().near(box, 1e9).empty());
  EXPECT_TRUE(BoxIndex2(std::vector<Segment2>()).near(box, 1e9).empty());
}

}  // namespace
}  // namespace ridgeline
