// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/hidden_walls/close_lines.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

using testing::IsEmpty;

TEST(CloseLines, AreTheNearestParallelOnesOnEachSide) {
  const std::vector<Segment2> segments{{{0.0, 0.0}, {40.0, 0.0}},
                                       {{2.0, 1.5}, {38.0, 1.5}},    // beside it
                                       {{0.0, 2.5}, {40.0, 2.5}},    // beyond that
                                       {{40.0, -2.0}, {0.0, -2.0}},  // the other side, turned round
                                       {{0.0, 7.0}, {40.0, 7.0}},    // too far
                                       {{20.0, -8.0}, {20.0, 8.0}},  // across
                                       {{45.0, 1.0}, {85.0, 1.0}}};  // further on
  const auto found = close_lines(segments);
  ASSERT_EQ(found[0].size(), 2U);
  EXPECT_EQ(found[0][0].id, 3);
  EXPECT_NEAR(found[0][0].distance_px, 2.0, 1e-12);
  EXPECT_NEAR(found[0][0].towards.y(), -1.0, 1e-12);
  EXPECT_EQ(found[0][1].id, 1);
  EXPECT_NEAR(found[0][1].towards.y(), 1.0, 1e-12);
  EXPECT_THAT(found[5], IsEmpty());
  EXPECT_THAT(found[6], IsEmpty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
