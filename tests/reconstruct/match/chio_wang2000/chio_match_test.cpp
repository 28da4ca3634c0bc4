// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/chio_match.h"

#include "tests/reconstruct/match/chio_wang2000/our_extensions.h"
#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

using test::PaintedPair;

/// A flat roof at 6 m; its east and west eaves run across the epipolar lines, the others along
/// them.
class ChioMatch : public testing::Test {
 protected:
  static constexpr PaintedPair::Roof kRoof{-6.0, -5.0, 6.0, 5.0, 6.0};

  ChioMatch() : pair_({kRoof}) { pair_.add_outline(kRoof); }

  /// The eaves along the epipolar lines leave no junction for the first process: one line is
  /// inclined.
  void add_inclined_line() { pair_.add_line({{6.0, 5.0, 6.0}, {9.0, 11.0, 6.0}}); }

  [[nodiscard]] ChioResult match(const ChioOptions& options = {}) const {
    return chio_match(pair_.pair(), options, {}, test::kOurExtensions);
  }

  PaintedPair pair_;
};

TEST_F(ChioMatch, FindsEavesWithTheirHeightAndLeavesEpipolarOnesAlone) {
  add_inclined_line();
  const ChioResult result = match();
  ASSERT_GE(result.lines.size(), 2U);
  EXPECT_EQ(result.outcomes[0], ChioOutcome::kEpipolarDegenerate);
  EXPECT_EQ(result.outcomes[2], ChioOutcome::kEpipolarDegenerate);
  for (const ChioLine& line : result.lines) {
    EXPECT_EQ(line.match.base, line.match.other);
    ASSERT_TRUE(line.line);
    // the edge is painted without blur, a staircase of a pixel, which is 0.3 m of height
    EXPECT_NEAR(line.line->segment.start.z(), 6.0, 0.4);
    EXPECT_NEAR(line.line->segment.end.z(), 6.0, 0.4);
    EXPECT_NEAR(line.chain.mean_height_m, 6.0, 0.2);
  }
}

TEST_F(ChioMatch, IsTheSameForAnyNumberOfThreads) {
  add_inclined_line();
  const auto matched = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    return match();
  };
  const ChioResult one = matched(1);
  const ChioResult two = matched(2);
  EXPECT_EQ(one.outcomes, two.outcomes);
  ASSERT_FALSE(one.lines.empty());
  ASSERT_EQ(one.lines.size(), two.lines.size());
  for (std::size_t i = 0; i < one.lines.size(); ++i) {
    EXPECT_EQ(one.lines[i].match.other, two.lines[i].match.other);
    EXPECT_EQ(one.lines[i].chain.mean_rate, two.lines[i].chain.mean_rate);
  }
}

TEST_F(ChioMatch, WithoutSegmentsFindsNothing) {
  for (View& view : pair_.views) view.segments.clear();
  EXPECT_TRUE(match().lines.empty());
  EXPECT_TRUE(match().outcomes.empty());
}

TEST_F(ChioMatch, RefusesOptionsAndImagesThatAreNone) {
  ChioOptions options;
  options.min_pieces = 0;
  EXPECT_THROW(match(options), std::invalid_argument);
  options = {};
  options.max_azimuth_deg = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(match(options), std::invalid_argument);
  pair_.views[1].image = cv::Mat();
  EXPECT_THROW(match(), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
