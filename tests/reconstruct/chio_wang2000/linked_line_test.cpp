// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/chio_wang2000/linked_line.h"

#include "tests/reconstruct/ok2011/match/painted_pair.h"

#include <gtest/gtest.h>

namespace ridgeline::reconstruct {
namespace {

TEST(LineThroughLinks, RunsTheWayOfTheLeftSegmentInWhicheverOrderTheFragmentsWereLinked) {
  constexpr double kGsd_m = 0.08;
  constexpr double kNear_m = 0.5;  // of ends on an edge painted without blur, 12 m apart
  test::PaintedPair pair({{-4.0, -6.0, 4.0, 6.0, 5.0}});
  const Segment3 edge{{-4.0, -6.0, 5.0}, {-4.0, 6.0, 5.0}};
  pair.add_segment(0, edge);
  pair.add_segment(1, {edge.start, {-4.0, -0.5, 5.0}});
  pair.add_segment(1, {{-4.0, 0.5, 5.0}, edge.end});
  for (const std::vector<int>& fragments : {std::vector{0, 1}, std::vector{1, 0}}) {
    const auto line = line_through_links(0, fragments, pair.searched(), kGsd_m, {});
    ASSERT_TRUE(line.has_value());
    EXPECT_LT((line->segment.start - edge.start).norm(), kNear_m) << fragments[0];
    EXPECT_LT((line->segment.end - edge.end).norm(), kNear_m) << fragments[0];
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
