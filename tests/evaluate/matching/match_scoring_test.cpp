// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/matching/match_scoring.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::evaluate {
namespace {

/// Edge 0 along y = 0, edge 1 along y = 10; the right image is shifted by 100 in x.
const std::vector<ReferenceEdge> kEdges = {{{{0, 0}, {50, 0}}, {{100, 0}, {150, 0}}},
                                           {{{0, 10}, {50, 10}}, {{100, 10}, {150, 10}}}};

Segment2 row(double y, double from, double to) { return {{from, y}, {to, y}}; }

struct Counts {
  std::size_t correct, wrong, missed, unjudged;
  friend bool operator==(const Counts&, const Counts&) = default;
};
Counts counts(const MatchingScore& s) {
  return {s.counts.n_correct, s.counts.n_false, s.counts.n_missed, s.n_unjudged};
}

Counts score(const std::vector<Segment2>& left,
             const std::vector<Segment2>& right,
             const std::vector<Correspondence>& matches) {
  return counts(score_matches(left, right, matches, kEdges));
}

TEST(ScoreMatches, CountsACommonEdgeAsCorrect) {
  // either direction of travel
  EXPECT_EQ(score({row(0.5, 10, 40)}, {row(-0.5, 140, 110)}, {{0, 0}}), (Counts{1, 0, 0, 0}));
}

TEST(ScoreMatches, CountsDifferentEdgesAsFalseAndNotAsMissedToo) {
  EXPECT_EQ(score({row(0, 10, 40)}, {row(10, 110, 140), row(0, 110, 140)}, {{0, 0}}),
            (Counts{0, 1, 0, 0}));
}

TEST(ScoreMatches, CountsAMatchAsFalseIfOnlyOneSegmentLiesOnAnEdge) {
  EXPECT_EQ(score({row(0, 10, 40)}, {row(30, 110, 140)}, {{0, 0}}), (Counts{0, 1, 0, 0}));
  EXPECT_EQ(score({row(30, 10, 40)}, {row(0, 110, 140)}, {{0, 0}}), (Counts{0, 1, 0, 0}));
}

TEST(ScoreMatches, LeavesMatchesAwayFromAllEdgesUnjudged) {
  EXPECT_EQ(score({row(30, 10, 40)}, {row(30, 110, 140)}, {{0, 0}}), (Counts{0, 0, 0, 1}));
}

TEST(ScoreMatches, DoesNotTakeALineBesideAnEdgeForTheEdge) {
  // 1.5 px away in both images, as a shadow: it could be either
  EXPECT_EQ(score({row(1.5, 10, 40)}, {row(1.5, 110, 140)}, {{0, 0}}), (Counts{0, 0, 0, 1}));
  EXPECT_EQ(score({row(1.5, 10, 40)}, {row(30, 110, 140)}, {{0, 0}}), (Counts{0, 0, 0, 1}));
  EXPECT_EQ(score({row(1.5, 10, 40)}, {row(0, 110, 140)}, {}), (Counts{0, 0, 0, 0}));
  // one certain segment suffices for a verdict
  EXPECT_EQ(score({row(1.5, 10, 40)}, {row(0, 110, 140)}, {{0, 0}}), (Counts{1, 0, 0, 0}));
  EXPECT_EQ(score({row(0.9, 10, 40)}, {row(30, 110, 140)}, {{0, 0}}), (Counts{0, 1, 0, 0}));
}

TEST(ScoreMatches, LeavesTheContinuationOfAnEdgeUnjudged) {
  EXPECT_EQ(score({row(0, 60, 90)}, {row(0, 110, 140)}, {{0, 0}}), (Counts{0, 0, 0, 1}));
  EXPECT_EQ(score({row(0, 10, 40)}, {row(0, 160, 190)}, {{0, 0}}), (Counts{0, 0, 0, 1}));
  // farther from the edge than its length; on another edge
  EXPECT_EQ(score({row(0, 110, 140)}, {row(0, 110, 140)}, {{0, 0}}), (Counts{0, 1, 0, 0}));
  EXPECT_EQ(score({row(10, 60, 90)}, {row(0, 110, 140)}, {{0, 0}}), (Counts{0, 1, 0, 0}));
}

TEST(ScoreMatches, MissesOnlyWhereTheRightImageHasTheSamePartOfTheEdge) {
  EXPECT_EQ(score({row(0, 10, 40)}, {row(0, 105, 135)}, {}), (Counts{0, 0, 1, 0}));
  EXPECT_EQ(score({row(0, 0, 20)}, {row(0, 130, 150)}, {}), (Counts{0, 0, 0, 0}));
  EXPECT_EQ(score({row(0, 10, 40)}, {row(10, 110, 140)}, {}), (Counts{0, 0, 0, 0}));
}

TEST(ScoreMatches, DoesNotMissWhatAParallelLineOfTheSameEdgeHasTaken) {
  EXPECT_EQ(score({row(0, 10, 40), row(1.5, 10, 40)}, {row(0, 110, 140)}, {{0, 0}}),
            (Counts{1, 0, 0, 0}));
  // another part of the edge is missed
  EXPECT_EQ(score({row(0, 0, 20), row(0, 25, 50)}, {row(0, 100, 150)}, {{0, 0}}),
            (Counts{1, 0, 1, 0}));
}

TEST(ScoreMatches, TakesASegmentForTheEdgeByDistanceAngleAndOverlap) {
  const std::vector<Segment2> right = {row(0, 100, 150)};
  EXPECT_EQ(score({row(1.9, 10, 40)}, right, {{0, 0}}).correct, 1U);
  EXPECT_EQ(score({row(2.1, 10, 40)}, right, {{0, 0}}).correct, 0U);
  EXPECT_EQ(score({row(0, 30, 69)}, right, {{0, 0}}).correct, 1U);  // 20 of 39 beside the edge
  EXPECT_EQ(score({row(0, 30, 71)}, right, {{0, 0}}).correct, 0U);
  EXPECT_EQ(score({row(0, -100, 26)}, right, {{0, 0}}).correct, 1U);  // 26 of the edge's 50
  EXPECT_EQ(score({row(0, -100, 24)}, right, {{0, 0}}).correct, 0U);
  // 8 px long, 1.4 px up: 10.1 degrees
  EXPECT_EQ(score({{{10, 0}, {18, 1.43}}}, right, {{0, 0}}).correct, 0U);
  EXPECT_EQ(score({{{10, 0}, {18, 1.39}}}, right, {{0, 0}}).correct, 1U);
}

TEST(ScoreMatches, CountsEveryFragment) {
  EXPECT_EQ(score({row(0, 0, 20), row(0, 25, 50)}, {row(0, 100, 150)}, {{0, 0}, {1, 0}}),
            (Counts{2, 0, 0, 0}));
}

TEST(ScoreMatches, RejectsIndicesOutOfRange) {
  EXPECT_THROW(score({row(0, 10, 40)}, {}, {{0, 0}}), std::invalid_argument);
  EXPECT_THROW(score({}, {row(0, 110, 140)}, {{0, 0}}), std::invalid_argument);
  EXPECT_THROW(score({row(0, 10, 40)}, {row(0, 110, 140)}, {{0, -1}}), std::invalid_argument);
}

TEST(ScoreMatches, JudgesByAListOfTrueMatches) {
  const std::vector<Correspondence> reference = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  // (0,0) right; (1,2) wrong; (7,3) wrong: 3 belongs to another; (8,9) unknown; 2 and 3 missing
  const std::vector<Correspondence> matches = {{0, 0}, {1, 2}, {7, 3}, {8, 9}};
  EXPECT_EQ(counts(score_matches(matches, reference)), (Counts{1, 2, 2, 1}));
}

TEST(ScoreMatches, SaysWhatEachMatchIsAndWhichAreMissed) {
  const MatchingScore s = score_matches(
      std::vector{row(0, 0, 20), row(0, 30, 50), row(30, 0, 20), row(10, 0, 20)},
      std::vector{row(0, 100, 120), row(10, 130, 150), row(30, 100, 120), row(10, 100, 120)},
      std::vector<Correspondence>{{0, 0}, {1, 1}, {2, 2}}, kEdges);
  EXPECT_EQ(s.verdicts,
            (std::vector{MatchVerdict::kCorrect, MatchVerdict::kFalse, MatchVerdict::kUnjudged}));
  ASSERT_EQ(s.missed.size(), 1U);
  EXPECT_EQ(s.missed[0].base, 3);
  EXPECT_EQ(s.missed[0].other, 3);
  EXPECT_EQ(s.counts.n_missed, 1U);
}

TEST(ScoreMatches, TakesAMatchOfAWrongPairAsFalseAndSaysNothingElseOfIt) {
  const std::vector<ReferenceEdge> reference = {{row(0, 0, 50), row(20, 100, 150), true}};
  const auto score_pair = [&](const Segment2& left, const Segment2& right) {
    return counts(score_matches(std::vector{left}, std::vector{right},
                                std::vector<Correspondence>{{0, 0}}, reference));
  };
  EXPECT_EQ(score_pair(row(0, 0, 50), row(20, 100, 150)), (Counts{0, 1, 0, 0}));
  EXPECT_EQ(score_pair(row(0, 0, 50), row(0, 100, 150)), (Counts{0, 0, 0, 1}));
  EXPECT_EQ(counts(score_matches(std::vector{row(0, 0, 50)}, std::vector{row(20, 100, 150)}, {},
                                 reference)),
            (Counts{0, 0, 0, 0}));
}

}  // namespace
}  // namespace ridgeline::evaluate
