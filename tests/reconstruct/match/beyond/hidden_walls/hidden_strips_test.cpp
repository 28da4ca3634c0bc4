// SPDX-License-Identifier: BSD-3-Clause
// A garden wall's east front, which the right camera sees as a dark strip of 4 px and the left one,
// in whose nadir it stands, does not see.
#include "reconstruct/match/beyond/hidden_walls/hidden_strips.h"

#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>

#include <utility>

namespace ridgeline::reconstruct {
namespace {

using test::PaintedPair;

const PaintedPair::Roof kWall{-5.0, -4.0, 0.0, 4.0, 1.2};
constexpr int kUpper = 0;
constexpr int kFoot = 1;

Segment3 east_front(double height_m) {
  return {{kWall.east, kWall.south, height_m}, {kWall.east, kWall.north, height_m}};
}

PaintedPair wall_that_the_right_camera_faces() {
  PaintedPair pair({kWall});
  pair.add_line(east_front(kWall.height_m));  // kUpper
  pair.add_segment(1, east_front(0.0));       // kFoot
  return pair;
}

using Candidates = std::vector<std::vector<Candidate>>;

Candidates candidates_of(const PaintedPair& pair) {
  return match_candidates(pair.searched(), Radiometry{}, {});
}

Candidates compared(const PaintedPair& pair, Candidates candidates) {
  compare_across_hidden_strips(pair.searched(), Radiometry{}, candidates);
  return candidates;
}

const Candidate& with_counterpart(const std::vector<Candidate>& candidates, int right) {
  const auto found = std::find_if(candidates.begin(), candidates.end(),
                                  [&](const Candidate& c) { return c.right == right; });
  if (found == candidates.end()) throw std::logic_error("no such candidate");
  return *found;
}

TEST(CompareAcrossHiddenStrips, TheFootOfAWallIsNotTheUpperEdgeThatTheOtherCameraSees) {
  const PaintedPair pair = wall_that_the_right_camera_faces();
  const Candidates before = candidates_of(pair);
  ASSERT_EQ(before.at(0).size(), 2U);
  const Candidates after = compared(pair, before);
  ASSERT_EQ(after.at(0).size(), 1U);
  EXPECT_EQ(after[0][0].right, kUpper);
  // beyond the strip lies the ground that the left image shows beside the wall
  EXPECT_GT(after[0][0].similarity, with_counterpart(before[0], kUpper).similarity);
  EXPECT_GT(after[0][0].measures.values[LineMeasures::kContrast], 0.9);  // nearly the same step
}

TEST(CompareAcrossHiddenStrips, TheOtherWayRoundToo) {
  PaintedPair pair = wall_that_the_right_camera_faces();
  std::swap(pair.views[0], pair.views[1]);
  const Candidates before = candidates_of(pair);
  ASSERT_EQ(before.at(kFoot).size(), 1U);
  const Candidates after = compared(pair, before);
  EXPECT_TRUE(after.at(kFoot).empty());
  ASSERT_EQ(after.at(kUpper).size(), 1U);
  EXPECT_GT(after[kUpper][0].similarity, before[kUpper][0].similarity);
}

TEST(CompareAcrossHiddenStrips, NothingChangesWhereTheOtherImageShowsSuchAStripToo) {
  PaintedPair pair = wall_that_the_right_camera_faces();
  pair.add_segment(0, {{kWall.east - 0.3, kWall.south, 0.0}, {kWall.east - 0.3, kWall.north, 0.0}});
  const Candidates before = candidates_of(pair);
  const Candidates after = compared(pair, before);
  ASSERT_EQ(after.at(0).size(), before.at(0).size());
  EXPECT_EQ(after[0][0].similarity, before[0][0].similarity);
}

TEST(CompareAcrossHiddenStrips, TheFootStaysWhereTheUpperEdgeLooksQuiteDifferent) {
  const PaintedPair pair = wall_that_the_right_camera_faces();
  Candidates candidates = candidates_of(pair);
  for (Candidate& c : candidates.at(0)) {
    c.appearance.sides.fill(SideAppearance{.ncc = -1.0, .colour_difference = 1.0});
    c.similarity = c.right == kFoot ? 1.0 : 0.0;
  }
  EXPECT_EQ(compared(pair, candidates).at(0).size(), 2U);
}

TEST(CompareAcrossHiddenStrips, AStripThatNoWallCouldShowAtThatWidthIsNone) {
  PaintedPair pair({});
  // the edges are 2.5 px apart; a wall that runs towards the camera's nadir shows no width
  pair.add_line({{-4.0, 0.0, 9.0}, {4.0, 1.0, 9.0}});
  pair.add_segment(0, {{-4.0, 0.2, 9.0}, {4.0, 1.2, 9.0}});
  const Candidates before = candidates_of(pair);
  const Candidates after = compared(pair, before);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i].size(), before[i].size());
}

}  // namespace
}  // namespace ridgeline::reconstruct
