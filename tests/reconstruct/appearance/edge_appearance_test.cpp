// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/appearance/edge_appearance.h"

#include "reconstruct/appearance/line_similarity.h"
#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

const test::PaintedPair::Roof kRoof{-6.0, -4.0, 2.0, 3.0, 9.0};

/// The east edge of a roof: roof on one side, ground far below on the other.
class EdgeAppearanceOfARoof : public ::testing::Test {
 protected:
  EdgeAppearanceOfARoof() : pair_({kRoof}) {
    const double z = kRoof.height_m;
    pair_.add_line({{kRoof.east, kRoof.south, z}, {kRoof.east, kRoof.north, z}});
  }

  /// Compares the edge with a right segment.
  [[nodiscard]] EdgeAppearance look_at(const EdgeSegment& right) const {
    const StereoSearch search(pair_.views[0].image_from_local, pair_.views[1].image_from_local,
                              pair_.heights_m);
    const Segment2& left = pair_.views[0].segments[0].line.segment;
    const auto searched = searched_segment(search, left);
    const auto overlap = epipolar_overlap(*searched, right.line.segment);
    return edge_appearance(
        {ImageSampler(pair_.views[0].image), ImageSampler(pair_.views[1].image), {}},
        {pair_.views[0].segments[0], right, *overlap},
        local_transfer(search.right_from_left, midpoint(left), 10.0));
  }

  test::PaintedPair pair_;
};

TEST_F(EdgeAppearanceOfARoof, AgreesOnTheSideOfTheRoofAndNotOnTheGroundBelow) {
  const EdgeAppearance appearance = look_at(pair_.views[1].segments[0]);
  const double left = appearance.sides[0]->ncc;
  const double right = appearance.sides[1]->ncc;
  EXPECT_GT(std::max(left, right), 0.8);  // the same texture, sampled twice
  EXPECT_LT(std::min(left, right), 0.6);  // 29 px of parallax away
  EXPECT_LT(
      std::min(appearance.sides[0]->colour_difference, appearance.sides[1]->colour_difference),
      0.02);
}

TEST_F(EdgeAppearanceOfARoof, DisagreesWithALineElsewhereOnTheRoof) {
  EdgeSegment other = pair_.views[1].segments[0];
  for (Segment2* s : {&other.line.segment, &other.in_image}) {
    s->start.x() -= 30.0;
    s->end.x() -= 30.0;
  }
  const EdgeAppearance appearance = look_at(other);
  EXPECT_LT(std::max(appearance.sides[0]->ncc, appearance.sides[1]->ncc), 0.6);
}

TEST_F(EdgeAppearanceOfARoof, LeavesOutASideBeyondTheImage) {
  EdgeSegment other = pair_.views[1].segments[0];
  const double at_border = other.in_image.start.x();
  for (Segment2* s : {&other.line.segment, &other.in_image}) {
    s->start.x() -= at_border;
    s->end.x() -= at_border;
  }
  const EdgeAppearance appearance = look_at(other);
  EXPECT_NE(appearance.sides[0].has_value(), appearance.sides[1].has_value());
  EXPECT_FALSE(appearance.profile_ncc.has_value());
}

TEST(StripFrame, HasStepsOfTheSofterEdge) {
  const Segment2 line{{0.0, 0.0}, {12.0, 0.0}};
  EdgeSegment left;
  left.line = {line, midpoint(line), 0.1, 0.001, 1.0};
  left.in_image = line;
  EdgeSegment right = left;
  const EpipolarOverlap whole{{0.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}, false};
  constexpr int kMaxSamplesAlong = 100;
  const StripFrame sharp = strip_frame({left, right, whole}, kMaxSamplesAlong);
  EXPECT_EQ(sharp.on_left.size(), 8U);  // every 1.5 px
  EXPECT_EQ(sharp.side_in_left.norm(), 1.0);
  right.scale_px = 2.0;
  const StripFrame soft = strip_frame({left, right, whole}, kMaxSamplesAlong);
  EXPECT_EQ(soft.on_left.size(), 4U);
  EXPECT_EQ(soft.side_in_left.norm(), 2.0);
}

TEST(RelativeRadiometry, BringsTheRightFlanksToMeanAndSpreadOfTheLeftOnes) {
  std::vector<EdgeSegment> left;
  std::vector<EdgeSegment> right;
  for (int i = 0; i < 20; ++i) {
    EdgeSegment segment = test::edge({{0, 0}, {10, 0}});
    segment.left.colour[0] = 0.1F + 0.03F * static_cast<float>(i);
    segment.right.colour[0] = 0.2F + 0.02F * static_cast<float>(i);
    left.push_back(segment);
    for (Flank* flank : {&segment.left, &segment.right}) {
      flank->colour[0] = 0.8F * flank->colour[0] + 0.05F;
    }
    right.push_back(segment);
  }
  const Radiometry map = relative_radiometry(left, right);
  EXPECT_NEAR(map.left_from_right({0.45F})[0], 0.5F, 1e-5F);  // 0.8 * 0.5 + 0.05
  EXPECT_EQ(relative_radiometry({}, right).gain[0], 1.0F);
}

TEST(LineMeasures, RewardSegmentsWhoseEndsCorrespond) {
  EdgeSegment left = test::edge({{0, 0}, {0, 40}});
  EdgeSegment right = left;
  EpipolarOverlap whole;
  whole.on_left = {0.0, 1.0};
  whole.on_right = {0.0, 1.0};
  EpipolarOverlap half = whole;
  half.on_right = {0.25, 0.75};
  const auto ends = [&](const EpipolarOverlap& overlap) {
    return line_measures({left, right, overlap}, {}, {}).values[LineMeasures::kEnds];
  };
  EXPECT_EQ(ends(whole), 1.0);
  EXPECT_NEAR(ends(half), std::exp(-10.0 / 3.0), 1e-12);  // the right one is 10 px longer each side
  EpipolarOverlap reversed = whole;
  reversed.on_right = {1.0, 0.0};
  EXPECT_EQ(ends(reversed), 1.0);
}

}  // namespace
}  // namespace ridgeline::reconstruct
