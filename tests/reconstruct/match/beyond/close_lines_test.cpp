// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/close_lines.h"

#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

using test::PaintedPair;
using testing::ElementsAre;
using testing::IsEmpty;

/// A line of 8 m that runs north.
Segment3 northwards(double east_m, double height_m) {
  return {{east_m, -4.0, height_m}, {east_m, 4.0, height_m}};
}

Candidate candidate(int right, double height_m) {
  Candidate c;
  c.right = right;
  c.overlap.on_left = c.overlap.on_right = {0.0, 1.0};
  c.overlap.height_m = {height_m, height_m};
  return c;
}

std::vector<std::vector<int>> kept(const PaintedPair& pair,
                                   std::vector<std::vector<Candidate>> candidates) {
  const std::array<CloseLines, 2> close{close_lines(ideal_segments(pair.views[0])),
                                        close_lines(ideal_segments(pair.views[1]))};
  keep_order_of_close_lines(pair.searched(), close, candidates);
  std::vector<std::vector<int>> ids;
  for (const std::vector<Candidate>& some : candidates) {
    std::vector<int>& list = ids.emplace_back();
    for (const Candidate& c : some) list.push_back(c.right);
  }
  return ids;
}

TEST(CloseLines, AreTheNearestParallelOnesOnEachSide) {
  const std::vector<Segment2> segments{{{0.0, 0.0}, {40.0, 0.0}},
                                       {{2.0, 1.5}, {38.0, 1.5}},    // beside it
                                       {{0.0, 2.5}, {40.0, 2.5}},    // beyond that
                                       {{40.0, -2.0}, {0.0, -2.0}},  // the other side, turned round
                                       {{0.0, 7.0}, {40.0, 7.0}},    // too far
                                       {{20.0, -8.0}, {20.0, 8.0}},  // across
                                       {{45.0, 1.0}, {85.0, 1.0}}};  // further on
  const auto found = close_lines(segments);
  ASSERT_EQ(found[0].size(), 2U);
  EXPECT_EQ(found[0][0].id, 3);
  EXPECT_NEAR(found[0][0].distance_px, 2.0, 1e-12);
  EXPECT_NEAR(found[0][0].towards.y(), -1.0, 1e-12);
  EXPECT_EQ(found[0][1].id, 1);
  EXPECT_NEAR(found[0][1].towards.y(), 1.0, 1e-12);
  EXPECT_THAT(found[5], IsEmpty());
  EXPECT_THAT(found[6], IsEmpty());
}

TEST(KeepOrderOfCloseLines, BordersOfAMarkingAreNotExchanged) {
  PaintedPair pair({});
  pair.add_line(northwards(2.0, 0.0));
  pair.add_line(northwards(2.12, 0.0));
  const std::vector<Candidate> both{candidate(0, 0.0), candidate(1, 0.0)};
  EXPECT_THAT(kept(pair, {both, both}), ElementsAre(ElementsAre(0), ElementsAre(1)));
}

TEST(KeepOrderOfCloseLines, AFragmentBesideALineSaysNothing) {
  PaintedPair pair({});
  pair.add_line(northwards(2.0, 0.0));
  pair.add_line({{2.12, 0.0, 0.0}, {2.12, 2.0, 0.0}});
  const std::vector<Candidate> both{candidate(0, 0.0), candidate(1, 0.0)};
  EXPECT_THAT(kept(pair, {both, both}), ElementsAre(ElementsAre(0, 1), ElementsAre(0, 1)));
}

}  // namespace
}  // namespace ridgeline::reconstruct
