// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/point_spread.h"

#include <gtest/gtest.h>

#include <set>

namespace ridgeline::simulate {
namespace {

TEST(SubPixelLattice, NoTwoRaysShareAColumnOrARow) {
  for (const int side : {1, 2, 3, 4}) {
    const SubPixelLattice lattice(side);
    std::set<int> columns;
    std::set<int> rows;
    for (const auto& [x, y] : lattice.positions) {
      columns.insert(x);
      rows.insert(y);
    }
    const auto n = static_cast<std::size_t>(side * side);
    EXPECT_EQ(columns.size(), n) << side;
    EXPECT_EQ(rows.size(), n) << side;
  }
}

TEST(PointSpread, KeepsTheLightWhereTheRayWas) {
  // a Gaussian of 0.55 px sampled at whole pixels and cut at 2 px: the centroid is off by less
  constexpr double kCentroidPx = 0.02;
  const PointSpread spread(0.55);
  for (int s = 0; s < kSubPixels; ++s) {
    double sum = 0.0;
    double moment = 0.0;
    for (int k = -PointSpread::kReachPx; k <= PointSpread::kReachPx; ++k) {
      const double weight = spread.at(s)[static_cast<std::size_t>(k + PointSpread::kReachPx)];
      sum += weight;
      moment += weight * k;
    }
    EXPECT_NEAR(moment / sum, (s + 0.5) / kSubPixels - 0.5, kCentroidPx) << s;
  }
}

}  // namespace
}  // namespace ridgeline::simulate
