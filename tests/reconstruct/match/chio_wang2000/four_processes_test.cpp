// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/four_processes.h"

#include "tests/reconstruct/match/chio_wang2000/our_extensions.h"
#include "tests/reconstruct/match/ok2011/stereo_pair.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

constexpr double kProcessGsd_m = 0.08;

/// Fig. 3 of the paper: the strong structure A of three lines; B, adjacent to A2, whose junction
/// the right image does not show; C, in range of A1; D, in range of C alone.
class FigureThree : public testing::Test {
 protected:
  enum Line { kA1, kA2, kA3, kB, kC, kD };

  FigureThree() {
    add({{0, 0, 8}, {5, 8, 8}});
    add({{0, 0, 8}, {5, -8, 8}});
    add({{0, 0, 8}, {-7, 3, 8}});
    const Segment3 b{{5, -8, 8}, {-1, -14, 8}};
    add(b, {point_at(b, 0.3), b.end});
    add({{3, 0, 8}, {8, 8, 8}});
    add({{7, 0, 8.3}, {12, 8, 8.3}});
  }

  void add(const Segment3& in_left, const Segment3& in_right) {
    views_[0].segments.push_back(test::edge(project(pair_.left, in_left)));
    views_[1].segments.push_back(test::edge(project(pair_.right, in_right)));
    add_candidate(static_cast<int>(views_[0].segments.size()) - 1,
                  static_cast<int>(views_[1].segments.size()) - 1, 0.9);
  }
  void add(const Segment3& line) { add(line, line); }

  /// A candidate as Core would pass it on.
  void add_candidate(int left, int right, double similarity) {
    candidates_.resize(views_[0].segments.size());
    candidates_[left].gsd_m = kProcessGsd_m;
    const auto searched = searched_segment(search_, views_[0].segments[left].line.segment);
    CoreCandidate candidate;
    candidate.right = right;
    candidate.overlap = *epipolar_overlap(*searched, views_[1].segments[right].line.segment);
    candidate.chain.n_reliable = 60;
    candidate.chain.mean_height_m =
        0.5 * (candidate.overlap.height_m[0] + candidate.overlap.height_m[1]);
    candidate.chain.height_sigma_m = 0.03;
    candidate.similarity = similarity;
    candidate.may_begin = true;
    candidates_[left].list.push_back(candidate);
    std::stable_sort(
        candidates_[left].list.begin(), candidates_[left].list.end(),
        [](const CoreCandidate& a, const CoreCandidate& b) { return a.similarity > b.similarity; });
  }

  [[nodiscard]] ProcessedSegments process(
      const ChioOptions& options = {}, const ChioExtensions& beyond = test::kOurExtensions) const {
    return four_processes({views_[0], views_[1], search_}, candidates_, options, beyond);
  }

  static std::ptrdiff_t count(const ProcessedSegments& processed) {
    return std::count_if(processed.acquired.begin(), processed.acquired.end(),
                         [](const auto& a) { return a.has_value(); });
  }

  test::StereoPair pair_;
  StereoSearch search_ = pair_.search();
  std::array<View, 2> views_;
  std::vector<CoreCandidates> candidates_;
};

TEST_F(FigureThree, IsAcquiredInTheOrderOfThePaper) {
  for (const ChioExtensions& beyond : {test::kOurExtensions, ChioExtensions{}}) {
    const auto [acquired, outcomes] = process({}, beyond);
    for (const auto& line : acquired) ASSERT_TRUE(line);
    EXPECT_EQ(acquired[kA1]->process, 1);
    EXPECT_EQ(acquired[kA1]->neighbour, -1);
    for (const Line line : {kA2, kA3}) {
      EXPECT_EQ(acquired[line]->process, 2);
      EXPECT_EQ(acquired[line]->neighbour, kA1);
      EXPECT_NEAR(acquired[line]->height_m, 8.0, 0.01);
    }
    EXPECT_EQ(acquired[kB]->process, 3);
    EXPECT_EQ(acquired[kB]->neighbour, kA2);
    EXPECT_EQ(acquired[kC]->process, 4);
    EXPECT_EQ(acquired[kC]->neighbour, kA1);
    EXPECT_EQ(acquired[kD]->process, 4);
    EXPECT_EQ(acquired[kD]->neighbour, kC);
    EXPECT_NEAR(acquired[kD]->height_m, 8.0, 0.01);
    EXPECT_EQ(acquired[kD]->limit_m, 0.5);
    EXPECT_FALSE(acquired[kD]->relaxed);
  }
}

TEST_F(FigureThree, LooserConstraintsNeverLoseALine) {
  std::ptrdiff_t before = 0;
  for (const double range_m : {0.0, 3.0, 5.0, 20.0}) {
    ChioOptions options;
    options.range_m = range_m;
    const auto n = count(process(options));
    EXPECT_GE(n, std::max<std::ptrdiff_t>(before, 4));  // A and B need no range
    before = n;
  }
  EXPECT_EQ(before, 6);
  before = 0;
  for (const double limit_m : {0.0, 0.1, 0.5, 5.0}) {
    ChioOptions options;
    options.height_difference_m = limit_m;
    const auto n = std::ranges::count_if(process(options).acquired,
                                         [](const auto& line) { return line && !line->relaxed; });
    EXPECT_GE(n, before);
    before = n;
  }
  EXPECT_EQ(before, 6);
}

TEST_F(FigureThree, HeightsTellWhatTheRelaxedLimitReaches) {
  add({{11, 0, 11}, {16, 8, 11}});  // 2.7 m above D
  add({{15, 0, 30}, {20, 8, 30}});  // far above everything
  add({{60, 0, 8}, {65, 8, 8}});    // far away
  const auto [acquired, outcomes] = process();
  ASSERT_TRUE(acquired[6]);
  EXPECT_TRUE(acquired[6]->relaxed);
  EXPECT_EQ(acquired[6]->limit_m, 5.0);
  EXPECT_EQ(outcomes[7], ChioOutcome::kHeight);
  EXPECT_EQ(outcomes[8], ChioOutcome::kOutOfReach);
}

TEST_F(FigureThree, TheHeightOfTheNeighbourChoosesAmongCandidates) {
  // a right segment that looks more like C, at 14 m; without the constraint it would win
  views_[1].segments.push_back(test::edge(project(pair_.right, Segment3{{3, 0, 14}, {8, 8, 14}})));
  const int wrong = static_cast<int>(views_[1].segments.size()) - 1;
  add_candidate(kC, wrong, 0.95);
  const Segment2 of_c = views_[0].segments[kC].line.segment;
  // the left image shows it as C, so the candidate's height follows from its place in the right
  // image
  const auto overlap =
      epipolar_overlap(*searched_segment(search_, of_c), views_[1].segments[wrong].line.segment);
  ASSERT_GT(overlap->height_m[0], 10.0);
  const auto [acquired, outcomes] = process();
  ASSERT_TRUE(acquired[kC]);
  EXPECT_EQ(candidates_[kC].list[acquired[kC]->candidate].right, kC);
}

TEST_F(FigureThree, TwoCandidatesOfOneAppearanceAreAmbiguousButByPaper) {
  views_[1].segments.push_back(
      test::edge(project(pair_.right, Segment3{{3.8, 0, 8.2}, {8.8, 8, 8.2}})));
  add_candidate(kC, static_cast<int>(views_[1].segments.size()) - 1, 0.85);
  ChioOptions options;
  options.height_difference_m = 5.0;  // 0.8 m aside means 3 m of height
  EXPECT_EQ(process(options).outcomes[kC], ChioOutcome::kAmbiguous);
  EXPECT_EQ(process().outcomes[kC], ChioOutcome::kMatched);  // the height decides
  EXPECT_EQ(process(options, ChioExtensions{}).outcomes[kC], ChioOutcome::kMatched);
}

TEST_F(FigureThree, ARightSegmentServesOneLeftEdge) {
  // a second left line beside C whose only candidate is C's counterpart
  views_[0].segments.push_back(test::edge(project(pair_.left, Segment3{{3.3, 0, 8}, {8.3, 8, 8}})));
  add_candidate(6, kC, 0.8);
  const auto [acquired, outcomes] = process();
  EXPECT_TRUE(acquired[kC]);
  EXPECT_FALSE(acquired[6]);
}

}  // namespace
}  // namespace ridgeline::reconstruct
