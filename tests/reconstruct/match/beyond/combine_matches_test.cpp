// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/combine_matches.h"

#include "tests/reconstruct/match/ok2011/stereo_pair.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

ChioLine chio_line(int left, int right, int process) {
  ChioLine line;
  line.match = {left, right, 0.5};
  line.acquired.process = process;
  return line;
}

TEST(CombineMatches, TakesPairwiseFirstAndWellConstrainedLinesOfChio) {
  // 5 continues 0; the others are parallel, far apart
  std::vector<EdgeSegment> left;
  for (int i = 0; i < 5; ++i) left.push_back(test::edge({{0, 50.0 * i}, {40, 50.0 * i}}));
  left.push_back(test::edge({{45, 0}, {80, 0}}));
  const std::vector<Correspondence> pairwise{{0, 10, 0.9, 3.0, "pairwise"},
                                             {1, 11, 0.8, 2.0, "guided"}};
  const std::vector<ChioLine> chio{
      chio_line(0, 10, 4),  // agrees
      chio_line(1, 99, 1),  // disagrees: pairwise stays
      chio_line(2, 12, 3),  // new
      chio_line(3, 13, 4),  // new, but loosely constrained
      chio_line(4, 10, 1),  // its mate belongs to another edge
      chio_line(5, 10, 2),  // its mate is shared with a fragment of the same edge
  };
  const std::vector<Correspondence> combined = combine_matches(left, pairwise, chio);
  ASSERT_EQ(combined.size(), 4U);
  EXPECT_EQ(combined[0].matcher, "pairwise+chio");
  EXPECT_EQ(combined[0].score, 0.9);
  EXPECT_EQ(combined[1].matcher, "guided");
  EXPECT_EQ(combined[1].other, 11);
  EXPECT_EQ(combined[2].matcher, "chio");
  EXPECT_EQ(combined[2].base, 2);
  EXPECT_EQ(combined[3].base, 5);
}

TEST(CombineMatches, KeepsAllFragmentsThatALineIsMatchedWith) {
  const std::vector<EdgeSegment> left{test::edge({{0, 0}, {80, 0}})};
  const std::vector<Correspondence> pairwise{{0, 10, 0.9, 3.0, "pairwise"},
                                             {0, 11, 0.8, 2.0, "pairwise"}};
  const std::vector<Correspondence> combined =
      combine_matches(left, pairwise, std::vector{chio_line(0, 11, 1)});
  ASSERT_EQ(combined.size(), 2U);
  EXPECT_EQ(combined[0].matcher, "pairwise");
  EXPECT_EQ(combined[1].matcher, "pairwise+chio");
}

TEST(CombineMatches, OfNothingAreNone) { EXPECT_TRUE(combine_matches({}, {}, {}).empty()); }

}  // namespace
}  // namespace ridgeline::reconstruct
