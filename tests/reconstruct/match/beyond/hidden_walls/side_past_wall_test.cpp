// SPDX-License-Identifier: BSD-3-Clause
// The east edge of a roof: the left camera, in whose nadir it stands, sees the ground beside it,
// the right one a black wall 29 px wide before that ground.
#include "reconstruct/match/beyond/hidden_walls/side_past_wall.h"

#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>

#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr double kEaves_m = 9.0;
const test::PaintedPair::Roof kRoof{-6.0, -4.0, 0.0, 3.0, kEaves_m};

class SidePastAWall : public ::testing::TestWithParam<bool> {
 protected:
  SidePastAWall() : pair_({kRoof}) {
    pair_.add_line({{kRoof.east, kRoof.south, kEaves_m}, {kRoof.east, kRoof.north, kEaves_m}});
    if (GetParam()) std::swap(pair_.views[0], pair_.views[1]);
    const StereoSearch search(pair_.views[0].image_from_local, pair_.views[1].image_from_local,
                              pair_.heights_m);
    const Segment2& left = pair_.views[0].segments[0].line.segment;
    overlap_ =
        *epipolar_overlap(*searched_segment(search, left), pair_.views[1].segments[0].line.segment);
    transfer_ = local_transfer(search.right_from_left, midpoint(left), kEaves_m);
    appearance_ = edge_appearance(images(), edges(), transfer_);
    worse_ = appearance_.sides[0]->agreement() < appearance_.sides[1]->agreement() ? 0 : 1;
  }

  [[nodiscard]] ImagePair images() const {
    return {ImageSampler(pair_.views[0].image), ImageSampler(pair_.views[1].image), {}};
  }

  [[nodiscard]] EdgePair edges() const {
    return {pair_.views[0].segments[0], pair_.views[1].segments[0], overlap_};
  }

  [[nodiscard]] EdgeAppearance past_wall(double most_drop_m) const {
    EdgeAppearance appearance = appearance_;
    appearance_past_wall(images(), edges(), transfer_, most_drop_m, appearance);
    return appearance;
  }

  test::PaintedPair pair_;
  EpipolarOverlap overlap_;
  LocalTransfer transfer_;
  EdgeAppearance appearance_;
  int worse_ = 0;
};

TEST_P(SidePastAWall, IsTheGroundThatTheOtherCameraSeesBesideTheEdge) {
  ASSERT_LT(appearance_.sides[worse_]->agreement(), 0.8);  // the wall is compared with ground
  const EdgeAppearance past = past_wall(kEaves_m + 5.0);
  // both show the same texture; the choice of a height costs some of the agreement
  EXPECT_GT(past.sides[worse_]->ncc, 0.5);
  EXPECT_GT(past.sides[worse_]->colour_agreement(), 0.5);
  EXPECT_TRUE(past.is_past_wall[worse_]);
}

TEST_P(SidePastAWall, IsNotLookedForBelowTheRangeOfHeights) {
  const EdgeAppearance past = past_wall(kEaves_m - 4.0);
  EXPECT_LT(past.sides[worse_]->ncc, 0.5);
}

TEST_P(SidePastAWall, IsNotOneWithoutRoomForAWall) {
  constexpr double kLessThanTwoPixels_m = 0.5;
  EXPECT_THAT(past_wall(kLessThanTwoPixels_m).is_past_wall, testing::Each(false));
}

TEST_P(SidePastAWall, LeavesTheSideOfTheRoofAsItIs) {
  const EdgeAppearance past = past_wall(kEaves_m + 5.0);
  EXPECT_EQ(past.sides[1 - worse_]->ncc, appearance_.sides[1 - worse_]->ncc);
  EXPECT_FALSE(past.is_past_wall[1 - worse_]);
  EXPECT_EQ(past.profile_ncc, appearance_.profile_ncc);
}

TEST_P(SidePastAWall, IsNotAskedForWhereItAgreesAnyway) {
  appearance_.sides[worse_]->ncc = 0.5;
  appearance_.sides[worse_]->colour_difference = 0.03;  // agreement of 0.55
  const EdgeAppearance past = past_wall(kEaves_m + 5.0);
  EXPECT_EQ(past.sides[worse_]->ncc, 0.5);
  EXPECT_FALSE(past.is_past_wall[worse_]);
}

INSTANTIATE_TEST_SUITE_P(InTheRightAndInTheLeftImage, SidePastAWall, ::testing::Bool());

}  // namespace
}  // namespace ridgeline::reconstruct
