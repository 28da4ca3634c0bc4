// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/structures.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

using ::testing::ElementsAre;

TEST(LinearStructures, StrongestHasMostMembersThenTheLongest) {
  const std::vector<Segment2> segments{
      {{0, 0}, {20, 0}},    {{0, 2}, {0, 30}},                           // two, 48 px
      {{100, 0}, {120, 0}}, {{100, 2}, {100, 20}}, {{98, 1}, {80, -9}},  // three
      {{200, 0}, {260, 0}}, {{200, 1}, {200, 50}},                       // two, 109 px
  };
  const std::vector<Structure> structures = linear_structures(segments);
  ASSERT_EQ(structures.size(), 3U);
  EXPECT_THAT(structures[0].members, ElementsAre(2, 3, 4));
  EXPECT_THAT(structures[1].members, ElementsAre(5, 6));
  EXPECT_THAT(structures[2].members, ElementsAre(0, 1));
  EXPECT_EQ(structures[1].junction_px, Eigen::Vector2d(200, 0));
  EXPECT_NEAR(structures[1].length_px, 109.0, 1e-9);
  EXPECT_NEAR(structures[1].precision_px, 0.5, 1e-9);  // 0 and 1 px
}

TEST(LinearStructures, AnEndMayMeetTheMiddle) {
  const std::vector<Segment2> segments{{{0, 0}, {100, 0}}, {{50, 3}, {50, 40}}};
  const std::vector<Structure> structures = linear_structures(segments);
  ASSERT_EQ(structures.size(), 1U);
  EXPECT_EQ(structures[0].junction_px, Eigen::Vector2d(50, 0));
}

TEST(LinearStructures, CrossingMiddlesAndFarEndsDoNotMeet) {
  EXPECT_TRUE(
      linear_structures(std::vector<Segment2>{{{0, 0}, {100, 0}}, {{50, -40}, {50, 40}}}).empty());
  EXPECT_TRUE(
      linear_structures(std::vector<Segment2>{{{0, 0}, {100, 0}}, {{0, 6}, {0, 40}}}).empty());
  EXPECT_TRUE(linear_structures({}).empty());
}

TEST(LinearStructures, SegmentsInLineDoNotMeet) {
  // below and above the limit of 20 degrees
  const Segment2 level{{0, 0}, {100, 0}};
  const Segment2 at_19_deg{{101, 0}, {201, 34}};
  const Segment2 at_21_deg{{101, 0}, {201, 38}};
  EXPECT_TRUE(linear_structures(std::vector{level, at_19_deg}).empty());
  EXPECT_EQ(linear_structures(std::vector{level, at_21_deg}).size(), 1U);
}

TEST(StructuresOfSegments, ListThemForEachSegment) {
  const std::vector<Segment2> segments{
      {{0, 0}, {50, 0}}, {{0, 1}, {0, 30}}, {{50, 1}, {50, 20}}, {{300, 300}, {330, 300}}};
  const std::vector<Structure> structures = linear_structures(segments);
  EXPECT_THAT(structures_of_segments(structures, segments.size()),
              ElementsAre(ElementsAre(0, 1), ElementsAre(0), ElementsAre(1), ElementsAre()));
}

}  // namespace
}  // namespace ridgeline::reconstruct
