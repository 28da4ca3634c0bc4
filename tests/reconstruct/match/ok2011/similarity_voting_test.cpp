// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/similarity_voting.h"

#include "reconstruct/match/ok2011/final_choice.h"
#include "tests/reconstruct/match/ok2011/stereo_pair.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

constexpr double kGsd_m = 0.08;

/// Left segments far apart, so that nothing but the given candidates and pairs speaks for a match.
class SimilarityVotes : public ::testing::Test {
 protected:
  int add_left(const Segment2& s) { return add(left_, s); }
  int add_right(const Segment2& s) { return add(right_, s); }

  void add_candidate(int left, int right, double similarity, double height_m = 0.0) {
    candidates_.resize(left_.segments.size());
    Candidate c;
    c.right = right;
    c.similarity = similarity;
    c.overlap.on_left = {0.0, 1.0};
    c.overlap.on_right = {0.0, 1.0};
    c.overlap.height_m = {height_m, height_m};
    candidates_[left].push_back(c);
  }

  [[nodiscard]] Supports vote(const std::vector<PairMatch>& pairs = {}) const {
    LocalTransfer transfer;
    transfer.gsd_m = kGsd_m;
    transfer.per_height = {px_per_m_, 0.0};
    return similarity_votes({left_, right_, candidates_}, pairs, transfer);
  }

  static int add(View& view, const Segment2& s) {
    view.segments.push_back(test::edge(s));
    return static_cast<int>(view.segments.size()) - 1;
  }

  View left_, right_;
  std::vector<std::vector<Candidate>> candidates_;
  double px_per_m_ = 3.25;  ///< parallax of a metre of height, at B/H 0.26
};

const Segment2 kFirst{{0, 0}, {0, 40}};
const Segment2 kFar{{1000, 0}, {1000, 40}};

TEST_F(SimilarityVotes, PreferTheCandidateThatLooksBetter) {
  add_left(kFirst);
  add_right(kFirst);
  add_right(kFar);
  add_candidate(0, 0, 0.9);
  add_candidate(0, 1, 0.5);
  const Supports supports = vote();
  EXPECT_GT(supports[0][0].probability, supports[0][1].probability);
  EXPECT_EQ(supports[0][0].votes, 0.0);
}

TEST_F(SimilarityVotes, LetAPairDecideBetweenEqualAppearances) {
  add_left(kFirst);
  add_left(kFar);
  for (int i = 0; i < 3; ++i) add_right({{500.0 * i, 0.0}, {500.0 * i, 40.0}});
  add_candidate(0, 0, 0.7);
  add_candidate(0, 1, 0.7);
  add_candidate(1, 2, 0.9);
  const std::vector<PairMatch> pairs = {{{0, 1}, 1, 0, 0.95, {}}};
  const Supports supports = vote(pairs);
  EXPECT_GT(supports[0][1].probability, 2.0 * supports[0][0].probability);
  EXPECT_EQ(supports[0][1].n_pairs, 1);
  EXPECT_EQ(supports[0][0].n_pairs, 0);
}

TEST_F(SimilarityVotes, CountEachPartnerOnce) {
  add_left(kFirst);
  add_left(kFar);
  for (int i = 0; i < 3; ++i) add_right({{500.0 * i, 0.0}, {500.0 * i, 40.0}});
  add_candidate(0, 0, 0.9);
  add_candidate(1, 1, 0.9);
  add_candidate(1, 2, 0.9);
  const std::vector<PairMatch> pairs = {{{0, 1}, 0, 0, 1.0, {}}, {{0, 1}, 0, 1, 1.0, {}}};
  EXPECT_LE(vote(pairs)[0][0].votes, 1.0);
}

TEST_F(SimilarityVotes, SupportAHeightThatNeighboursShare) {
  add_left(kFirst);
  add_left({{5, 0}, {5, 40}});
  for (int i = 0; i < 3; ++i) add_right({{500.0 * i, 0.0}, {500.0 * i, 40.0}});
  add_candidate(0, 0, 0.7, 10.0);
  add_candidate(0, 1, 0.7, 0.0);
  add_candidate(1, 2, 0.95, 10.0);
  const Supports supports = vote();
  EXPECT_GT(supports[0][0].height, 0.6);
  EXPECT_LT(supports[0][1].height, 0.4);
  EXPECT_GT(supports[0][0].probability, supports[0][1].probability);
}

TEST_F(SimilarityVotes, TakeHeightsForTheSameThatTheParallaxHardlyTellsApart) {
  add_left(kFirst);
  add_left({{5, 0}, {5, 40}});
  for (int i = 0; i < 2; ++i) add_right({{500.0 * i, 0.0}, {500.0 * i, 40.0}});
  add_candidate(0, 0, 0.7, 10.0);
  add_candidate(1, 1, 0.95, 12.0);
  EXPECT_LT(vote()[0][0].height, 0.4);
  px_per_m_ = 1.0;  // the heights then differ by 2 px
  EXPECT_GT(vote()[0][0].height, 0.5);
}

TEST_F(SimilarityVotes, LetTwoEdgesCompeteForOneCounterpartButNotTwoFragments) {
  add_left(kFirst);
  add_left(kFar);  // another edge
  add_right({{0, 0}, {0, 100}});
  add_candidate(0, 0, 0.9);
  add_candidate(1, 0, 0.9);
  const double competing = vote()[0][0].probability;
  left_.segments[1] = test::edge({{0, 60}, {0, 100}});  // continues the first
  candidates_[0][0].overlap.on_right = {0.0, 0.4};
  candidates_[1][0].overlap.on_right = {0.6, 1.0};
  EXPECT_GT(vote()[0][0].probability, 1.3 * competing);
}

EpipolarOverlap overlap_on_left(double from, double to) {
  EpipolarOverlap overlap;
  overlap.on_left = {from, to};
  return overlap;
}

TEST(MayBeCounterpartsOfOne, TakesFragmentsWithPartsOfTheirOwn) {
  const Segment2 a{{0, 0}, {40, 0}};
  const Segment2 b{{50, 0}, {90, 0}};
  const EpipolarOverlap first = overlap_on_left(0.0, 0.45);
  EXPECT_TRUE(may_be_counterparts_of_one({a, first}, {b, overlap_on_left(0.55, 1.0)}));
  EXPECT_FALSE(may_be_counterparts_of_one({a, first}, {b, overlap_on_left(0.2, 0.6)}));
  EXPECT_FALSE(
      may_be_counterparts_of_one({a, first}, {{{50, 9}, {90, 9}}, overlap_on_left(0.55, 1.0)}));
}

TEST(MayBeCounterpartsOfOne, TakesNoneAlongTheEpipolarLineWhereTheirPartsAreAGuess) {
  EpipolarOverlap first = overlap_on_left(0.0, 0.45);
  first.aligned = true;
  EXPECT_FALSE(may_be_counterparts_of_one({{{0, 0}, {40, 0}}, first},
                                          {{{50, 0}, {90, 0}}, overlap_on_left(0.55, 1.0)}));
}

TEST(AreFragments, TakesCollinearSegmentsOnly) {
  const Segment2 a{{0, 0}, {40, 0}};
  EXPECT_TRUE(are_fragments(a, {{50, 1}, {90, 1}}));
  EXPECT_TRUE(are_fragments({{90, 1}, {50, 1}}, a));
  EXPECT_FALSE(are_fragments(a, {{50, 4}, {90, 4}}));     // parallel, 4 px beside
  EXPECT_FALSE(are_fragments(a, {{50, 0}, {85, 20}}));    // turned
  EXPECT_FALSE(are_fragments(a, {{20, -9}, {20, 9}}));    // crossing
  EXPECT_FALSE(are_fragments(a, {{0, 2.9}, {40, 2.9}}));  // side by side
}

TEST_F(SimilarityVotes, FinalChoiceGivesAMateToTheMoreProbableEdgeAndSaysWhyToTheOther) {
  add_left(kFirst);
  add_left(kFar);
  add_right(kFirst);
  add_candidate(0, 0, 0.9);
  add_candidate(1, 0, 0.9);
  Supports supports(2, std::vector<Support>(1));
  supports[0][0].probability = 0.6;
  supports[1][0].probability = 0.7;
  for (std::vector<Support>& of_line : supports) of_line[0].votes = 1.0;
  const MatchResult result = final_choice({left_, right_, candidates_}, supports, {}, {});
  ASSERT_EQ(result.matches.size(), 1U);
  EXPECT_EQ(result.matches[0].base, 1);
  EXPECT_EQ(result.outcomes[0], MatchOutcome::kLostVote);
  EXPECT_EQ(result.outcomes[1], MatchOutcome::kMatched);
}

TEST_F(SimilarityVotes, FinalChoiceTellsWeakFromAmbiguousCandidates) {
  add_left(kFirst);
  add_left(kFar);
  for (int i = 0; i < 2; ++i) add_right({{500.0 * i, 0.0}, {500.0 * i, 40.0}});
  add_candidate(0, 0, 0.9);
  add_candidate(0, 1, 0.9);
  add_candidate(1, 0, 0.1);
  Supports supports = {std::vector<Support>(2), std::vector<Support>(1)};
  supports[0][0].probability = 0.29;
  supports[0][1].probability = 0.28;
  supports[1][0].probability = 0.01;
  supports[1][0].n_pairs = 1;
  for (std::vector<Support>& of_line : supports) of_line[0].votes = 1.0;
  const MatchResult result = final_choice({left_, right_, candidates_}, supports, {}, {});
  EXPECT_TRUE(result.matches.empty());
  EXPECT_EQ(result.outcomes[0], MatchOutcome::kAmbiguous);
  EXPECT_EQ(result.outcomes[1], MatchOutcome::kLowScore);
}

TEST_F(SimilarityVotes, FinalChoiceAsksMoreOfTheShortestSegments) {
  const auto with_short_counterpart = [](double length_px) {
    return Segment2{{500.0 * length_px, 0.0}, {500.0 * length_px, length_px}};
  };
  const std::array<double, 3> lengths_px{11.0, 13.0, 11.5};
  Supports supports(lengths_px.size(), std::vector<Support>(1));
  for (std::size_t i = 0; i < lengths_px.size(); ++i) {
    add_left({{500.0 * lengths_px[i], 0.0}, {500.0 * lengths_px[i], 40.0}});
    add_right(with_short_counterpart(lengths_px[i]));
    add_candidate(static_cast<int>(i), static_cast<int>(i), 0.9);
    supports[i][0].votes = 1.0;
    supports[i][0].n_pairs = 1;
    supports[i][0].probability = 0.8;
  }
  supports[2][0].probability = 0.95;
  const MatchResult result = final_choice({left_, right_, candidates_}, supports, {}, {});
  EXPECT_EQ(result.outcomes[0], MatchOutcome::kLowScore);
  EXPECT_EQ(result.outcomes[1], MatchOutcome::kMatched);
  EXPECT_EQ(result.outcomes[2], MatchOutcome::kMatched);
}

TEST_F(SimilarityVotes, FinalChoiceAsksMoreOfSegmentsOfUnlikeLengths) {
  const std::array<double, 3> lengths_px{29.0, 31.0, 29.0};  // three quarters of 40 px are 30 px
  Supports supports(lengths_px.size(), std::vector<Support>(1));
  for (std::size_t i = 0; i < lengths_px.size(); ++i) {
    const double x = 500.0 * static_cast<double>(i);
    add_left({{x, 0.0}, {x, 40.0}});
    add_right({{x, 0.0}, {x, lengths_px[i]}});
    add_candidate(static_cast<int>(i), static_cast<int>(i), 0.9);
    supports[i][0].votes = 1.0;
    supports[i][0].n_pairs = 1;
    supports[i][0].probability = 0.5;
  }
  supports[2][0].probability = 0.65;
  const MatchResult result = final_choice({left_, right_, candidates_}, supports, {}, {});
  EXPECT_EQ(result.outcomes[0], MatchOutcome::kLowScore);
  EXPECT_EQ(result.outcomes[1], MatchOutcome::kMatched);
  EXPECT_EQ(result.outcomes[2], MatchOutcome::kMatched);
}

TEST_F(SimilarityVotes, FinalChoiceTakesTheLongerFragmentWhereTheShortestIsTheMoreProbable) {
  add_left({{0.0, 0.0}, {0.0, 45.0}});
  add_right({{0.0, 0.0}, {0.0, 11.0}});
  add_right({{0.0, 14.0}, {0.0, 45.0}});
  add_candidate(0, 0, 0.9);
  add_candidate(0, 1, 0.9);
  Supports supports(1, std::vector<Support>(2));
  for (Support& support : supports[0]) {
    support.votes = 1.0;
    support.n_pairs = 1;
  }
  supports[0][0].probability = 0.8;
  supports[0][1].probability = 0.75;
  const MatchResult result = final_choice({left_, right_, candidates_}, supports, {}, {});
  ASSERT_EQ(result.matches.size(), 1U);
  EXPECT_EQ(result.matches[0].other, 1);
}

TEST_F(SimilarityVotes, FinalChoiceTakesALineAsIsolatedWhosePartnersAreTooShortToBeMatched) {
  for (int i = 0; i < 3; ++i) {
    const Segment2 segment{{500.0 * i, 0.0}, {500.0 * i, i == 0 ? 40.0 : 11.0}};
    add_left(segment);
    add_right(segment);
    add_candidate(i, i, 0.9);
  }
  Supports supports(3, std::vector<Support>(1));
  supports[0][0].probability = 0.99;  // without votes
  supports[1][0].probability = supports[2][0].probability = 0.6;
  const std::vector<BasePair> pairs{{0, 1}, {0, 2}};
  const MatchResult result = final_choice({left_, right_, candidates_}, supports, pairs, {});
  EXPECT_EQ(result.outcomes[0], MatchOutcome::kMatched);
}

TEST_F(SimilarityVotes, FinalChoiceDropsALineThatItsMatchedPartnersDoNotVoteFor) {
  constexpr double kApart_px = 500.0;
  for (int i = 0; i < 3; ++i) {
    const Segment2 segment{{kApart_px * i, 0.0}, {kApart_px * i, 40.0}};
    add_left(segment);
    add_right(segment);
    add_candidate(i, i, 0.9);
  }
  Supports supports(3, std::vector<Support>(1));
  for (std::vector<Support>& of_line : supports) of_line[0].probability = 0.9;
  supports[1][0].votes = 1.0;
  supports[2][0].votes = 1.0;
  const std::vector<BasePair> pairs{{0, 1}, {0, 2}, {1, 2}};
  const MatchResult result = final_choice({left_, right_, candidates_}, supports, pairs, {});
  EXPECT_EQ(result.matches.size(), 2U);
  EXPECT_EQ(result.outcomes[0], MatchOutcome::kNoPair);
  // without partners the appearance of the line decides, and it has to be better
  EXPECT_EQ(final_choice({left_, right_, candidates_}, supports, {}, {}).matches.size(), 2U);
  supports[0][0].probability = 0.99;
  EXPECT_EQ(final_choice({left_, right_, candidates_}, supports, {}, {}).matches.size(), 3U);
}

}  // namespace
}  // namespace ridgeline::reconstruct
