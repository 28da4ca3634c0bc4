// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/footprint.h"

#include "evaluate/judge/point_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kFootprintTol = 1e-12;  // a few roundings of metre-sized numbers

TEST(FootprintOf, HasItsAxesAlongAndLeftOfTheLine) {
  const Footprint f = footprint_of({{1, 2, 50}, {1, 6, -3}});
  EXPECT_NEAR(f.length_m, 4.0, kFootprintTol);
  EXPECT_NEAR(f.s({7, 3}), 1.0, kFootprintTol);
  EXPECT_NEAR(f.t({7, 3}), -6.0, kFootprintTol);  // east of a line that runs north is right of it
  EXPECT_TRUE(f.middle().isApprox(Eigen::Vector2d(1, 4), kFootprintTol));
}

TEST(FootprintOf, RejectsAVerticalSegment) {
  EXPECT_THROW(footprint_of({{1, 2, 0}, {1, 2, 9}}), std::invalid_argument);
}

TEST(PointsBeside, TakesTheCorridorAtAnyHeight) {
  const std::vector<Eigen::Vector3d> points{{5, 1.4, 0},  {5, 1.6, 0},  {5, -1.4, 900},
                                            {-0.4, 0, 0}, {-0.6, 0, 0}, {10.4, 0, 0}};
  const PointGrid grid = PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
  std::vector<std::uint32_t> found;
  for (const ZonePoint& p : points_beside(grid, footprint_of({{0, 0, 7}, {10, 0, 7}}), 1.5, 0.5)) {
    found.push_back(p.index);
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, (std::vector<std::uint32_t>{0, 2, 3, 5}));
}

}  // namespace
}  // namespace ridgeline::evaluate
