// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/match_pairwise.h"

#include "reconstruct/match/beyond/extensions.h"
#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cmath>
#include <set>

namespace ridgeline::reconstruct {
namespace {

using test::PaintedPair;

/// Two roofs of 9 m and 5 m over ground at 0 m, 12.5 px per metre.
const PaintedPair::Roof kHigh{-11.0, -4.0, -3.0, 3.0, 9.0};
const PaintedPair::Roof kLow{2.0, -6.0, 9.0, 1.0, 5.0};

PaintedPair two_roofs() {
  PaintedPair pair({kHigh, kLow});
  pair.add_outline(kHigh);
  pair.add_outline(kLow);
  return pair;
}

MatchResult match(const PaintedPair& pair, const CandidateOptions& candidates = {}) {
  return match_pairwise(pair.pair(), {}, candidates, match_extensions({}, candidates));
}

TEST(MatchPairwise, FindsTheOutlinesOfFlatRoofs) {
  const PaintedPair pair = two_roofs();
  const MatchResult result = match(pair);
  ASSERT_EQ(result.outcomes.size(), 8U);
  ASSERT_EQ(result.matches.size(), 8U);
  for (const Correspondence& m : result.matches) EXPECT_EQ(m.base, m.other);
}

TEST(MatchPairwise, FindsAnIsolatedLineByItsAppearance) {
  PaintedPair pair({kHigh});
  // only the border of the roof is there, no other segment in either image
  const double z = kHigh.height_m;
  pair.add_line({{kHigh.east, kHigh.south, z}, {kHigh.east, kHigh.north, z}});
  const MatchResult result = match(pair);
  ASSERT_EQ(result.matches.size(), 1U);
  EXPECT_EQ(result.matches[0].votes, 0.0);
}

TEST(MatchPairwise, HasNoCandidateThatWouldBeSteeperThanARoof) {
  PaintedPair pair({kHigh});
  const double z = kHigh.height_m;
  const double rise_m = 0.8 * (kHigh.north - kHigh.south);  // 39 degrees
  pair.add_line({{kHigh.east, kHigh.south, z}, {kHigh.east, kHigh.north, z + rise_m}});
  EXPECT_NE(match(pair).outcomes.at(0), MatchOutcome::kNoCandidate);
  CandidateOptions flat;
  flat.max_slope_deg = 20.0;
  EXPECT_EQ(match(pair, flat).outcomes.at(0), MatchOutcome::kNoCandidate);
}

TEST(MatchPairwise, LeavesALineWithoutCounterpartAloneAndSaysWhy) {
  PaintedPair pair = two_roofs();
  pair.add_segment(0, {{-2.0, 8.0, 0.0}, {-2.0, 12.0, 0.0}});  // only the left image shows it
  const MatchResult result = match(pair);
  EXPECT_EQ(result.matches.size(), 8U);
  EXPECT_EQ(result.outcomes.back(), MatchOutcome::kNoCandidate);
}

TEST(MatchPairwise, GivesFragmentsOfOneEdgeTheirCommonCounterpart) {
  PaintedPair pair({kHigh});
  const double z = kHigh.height_m;
  const Eigen::Vector3d south(kHigh.east, kHigh.south, z);
  const Eigen::Vector3d north(kHigh.east, kHigh.north, z);
  pair.add_segment(0, {south, 0.55 * south + 0.45 * north});
  pair.add_segment(0, {0.45 * south + 0.55 * north, north});
  pair.add_segment(1, {south, north});
  const MatchResult result = match(pair);
  ASSERT_EQ(result.matches.size(), 2U);
  EXPECT_EQ(result.matches[0].other, 0);
  EXPECT_EQ(result.matches[1].other, 0);
}

constexpr int kEast = 1;  // east side in the outline of the high roof

/// The right image shows the east edge of the high roof in two parts, each over `share` of it.
std::vector<int> counterparts_of_the_east_edge(double share) {
  PaintedPair pair = two_roofs();
  const Segment3 edge{{kHigh.east, kHigh.south, kHigh.height_m},
                      {kHigh.east, kHigh.north, kHigh.height_m}};
  std::vector<EdgeSegment>& right = pair.views[1].segments;
  pair.add_segment(1, {point_at(edge, 1.0 - share), edge.end});
  right[kEast] = right.back();
  right.pop_back();
  pair.add_segment(1, {edge.start, point_at(edge, share)});
  std::vector<int> counterparts;
  for (const Correspondence& m : match(pair).matches) {
    if (m.base == kEast) counterparts.push_back(m.other);
  }
  return counterparts;
}

TEST(MatchPairwise, GivesALineAllFragmentsOfItsCounterpart) {
  EXPECT_THAT(counterparts_of_the_east_edge(0.45), testing::ElementsAre(kEast, 8));
}

TEST(MatchPairwise, GivesALineOneOfTwoSegmentsThatLieSideBySide) {
  EXPECT_EQ(counterparts_of_the_east_edge(0.7).size(), 1U);
}

TEST(MatchPairwise, NeverGivesOneCounterpartToTwoEdges) {
  PaintedPair pair = two_roofs();
  // a second left line beside the east edge of the high roof, on the ground: it has no counterpart
  pair.add_segment(0, {{-2.0, -4.0, 0.0}, {-2.0, 3.0, 0.0}});
  const MatchResult result = match(pair);
  ASSERT_EQ(result.matches.size(), 8U);
  std::set<int> rights;
  for (const Correspondence& m : result.matches) {
    EXPECT_TRUE(rights.insert(m.other).second) << m.other;
  }
}

TEST(MatchPairwise, LetsPairsVoteThatAWideBaseTurns) {
  // the verges rise by 0.5: between them and the eaves, 17 degrees of turn and more at B/H 0.6
  PaintedPair::Roof roof{-1.0, -3.0, 6.0, 3.0, 4.0};
  roof.rise = 0.5;
  PaintedPair pair({roof}, test::StereoPair::kWideBase_m);
  pair.add_outline(roof);
  const MatchResult result = match(pair);
  ASSERT_EQ(result.matches.size(), 4U);
  for (const Correspondence& m : result.matches) EXPECT_GT(m.votes, 0.0) << m.base;
}

TEST(MatchPairwise, IsTheSameForAnyNumberOfThreads) {
  const PaintedPair pair = two_roofs();
  const MatchResult all = match(pair);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const MatchResult single = match(pair);
  ASSERT_EQ(all.matches.size(), single.matches.size());
  for (std::size_t i = 0; i < all.matches.size(); ++i) {
    EXPECT_EQ(all.matches[i].other, single.matches[i].other);
    EXPECT_EQ(all.matches[i].score, single.matches[i].score);
    EXPECT_EQ(all.matches[i].votes, single.matches[i].votes);
  }
}

TEST(MatchPairwise, GivesNothingForImagesWithoutSegments) {
  PaintedPair pair = two_roofs();
  pair.views[1].segments.clear();
  const MatchResult result = match(pair);
  EXPECT_TRUE(result.matches.empty());
  for (const MatchOutcome outcome : result.outcomes) {
    EXPECT_EQ(outcome, MatchOutcome::kNoCandidate);
  }
  pair.views[0].segments.clear();
  EXPECT_TRUE(match(pair).outcomes.empty());
}

TEST(MatchPairwise, RejectsWhatItCannotWorkWith) {
  const PaintedPair good = two_roofs();
  PaintedPair inverted = good;
  std::swap(inverted.heights_m[0], inverted.heights_m[1]);
  EXPECT_THROW((void)match(inverted), std::invalid_argument);
  PaintedPair bytes = good;
  bytes.views[0].image.convertTo(bytes.views[0].image, CV_8U);
  EXPECT_THROW((void)match(bytes), std::invalid_argument);
  PaintedPair one_place = good;
  one_place.views[1].image_from_local = one_place.views[0].image_from_local;
  EXPECT_THROW((void)match(one_place), std::invalid_argument);
  CandidateOptions options;
  options.max_turn_deg = 91.0;
  EXPECT_THROW((void)match(good, options), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
