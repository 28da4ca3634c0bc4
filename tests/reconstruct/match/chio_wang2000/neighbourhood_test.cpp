// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/neighbourhood.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kNeighbourGsd_m = 0.1;

/// Two segments that cross, one beyond both and one 20 px beside the first.
const std::vector<Segment2> kSegments{
    {{0, 0}, {100, 0}}, {{50, -40}, {50, 40}}, {{110, 20}, {210, 20}}, {{0, 20}, {30, 20}}};

std::vector<CoreCandidates> with_candidates() {
  CoreCandidates one;
  one.list.resize(1);
  one.gsd_m = kNeighbourGsd_m;
  return std::vector<CoreCandidates>(kSegments.size(), one);
}

auto neighbours(auto... left) { return ElementsAre(testing::Field(&Neighbour::left, left)...); }

TEST(SegmentsInRange, AreTheNearestFirst) {
  const Neighbourhood found = segments_in_range(kSegments, with_candidates(), 2.1);  // 21 px
  EXPECT_THAT(found, ElementsAre(neighbours(1, 3), neighbours(0, 3), IsEmpty(), neighbours(0, 1)));
  EXPECT_EQ(found[0][0].distance_px, 0.0);
  EXPECT_NEAR(found[0][1].distance_px, 20.0, 1e-9);
}

TEST(SegmentsInRange, OfZeroAreNoneThoughSegmentsCross) {
  EXPECT_THAT(segments_in_range(kSegments, with_candidates(), 0.0), Each(IsEmpty()));
  EXPECT_EQ(segments_in_range(kSegments, with_candidates(), 0.0).size(), kSegments.size());
}

TEST(SegmentsInRange, AreNotAskedForByASegmentWithoutCandidates) {
  std::vector<CoreCandidates> candidates = with_candidates();
  candidates[0].list.clear();
  const Neighbourhood found = segments_in_range(kSegments, candidates, 2.1);
  EXPECT_THAT(found[0], IsEmpty());
  EXPECT_THAT(found[1], neighbours(0, 3));
}

}  // namespace
}  // namespace ridgeline::reconstruct
