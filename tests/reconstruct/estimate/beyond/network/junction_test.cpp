// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/junction.h"

#include "tests/reconstruct/support/conditioned_scene.h"
#include "tests/reconstruct/support/line_group.h"

#include <gtest/gtest.h>

namespace ridgeline::reconstruct {
namespace {

/// The junction of a line of 100 px and one at right angles to it, which starts `gap_px` beyond the
/// place `parameter`.
Junction junction_at(double parameter, double gap_px) {
  const test::ConditionedScene scene;
  const Segment3 line = test::make_segment(scene.scene, test::line_at(45));
  const Segment3 other = test::make_neighbour(
      scene.scene, line, {.parameter = parameter, .angle_deg = 135, .rise_m = 0, .gap_px = gap_px});
  return junction(scene.frames, scene.observe(test::exact_pair(scene.scene, line)),
                  scene.observe(test::exact_pair(scene.scene, other)),
                  BuildingOptions().sigma_meeting_m);
}

TEST(Junction, PriorIsThatOfItsKind) {
  EXPECT_DOUBLE_EQ(junction_at(0.0, 0.0).prior, 0.87);    // corner
  EXPECT_DOUBLE_EQ(junction_at(1.0, 2.0).prior, 0.87);    // corner that is nearly reached
  EXPECT_DOUBLE_EQ(junction_at(0.5, 0.0).prior, 0.7);     // an end on the line
  EXPECT_DOUBLE_EQ(junction_at(0.5, -30.0).prior, 0.35);  // crossing
  EXPECT_DOUBLE_EQ(junction_at(0.5, 10.0).prior, 0.45);   // beyond the end of the other
  EXPECT_DOUBLE_EQ(junction_at(1.2, 0.0).prior, 0.45);    // beyond the end of the line
}

TEST(Junction, LinesThatReachEachOtherMissByLess) {
  const double sigma_m = BuildingOptions().sigma_meeting_m;
  EXPECT_DOUBLE_EQ(junction_at(0.0, 0.0).sigma_m, 0.5 * sigma_m);
  EXPECT_DOUBLE_EQ(junction_at(0.5, 0.0).sigma_m, 0.5 * sigma_m);
  EXPECT_DOUBLE_EQ(junction_at(0.5, 10.0).sigma_m, sigma_m);
}

}  // namespace
}  // namespace ridgeline::reconstruct
