// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/bends.h"

#include "tests/support/random.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using testing::ElementsAre;

constexpr double kNoisePx = 0.05;  // noise of edge pixels in an aerial image

/// Edge pixels of a line along x, displaced by `across`.
template <typename Across>
Points edge(int n, Across across, double noise_px = kNoisePx) {
  test::Random random(3);
  Points points;
  for (int i = 0; i < n; ++i) points.emplace_back(i, across(i) + random.normal(noise_px));
  return points;
}

TEST(Bends, AStraightEdgeHasNone) {
  const Points points = edge(400, [](int i) { return 0.1 * i; });
  EXPECT_THAT(bends(points, {}), ElementsAre(0, 400));
}

TEST(Bends, AStepOfAFractionOfAPixelCutsTheEdge) {
  const Points points = edge(200, [](int i) { return i < 80 ? 0.0 : 1.0; });
  const std::vector<std::size_t> borders = bends(points, {});
  ASSERT_EQ(borders.size(), 3U);
  EXPECT_NEAR(static_cast<double>(borders[1]), 80.0, 3.0);  // noise moves the cut by a pixel or two
}

TEST(Bends, EveryPartOfABrokenLineIsOne) {
  const Points points = edge(300, [](int i) { return i < 100 || i >= 200 ? 0.0 : 1.0; });
  const std::vector<std::size_t> borders = bends(points, {});
  ASSERT_EQ(borders.size(), 4U);
  EXPECT_NEAR(static_cast<double>(borders[1]), 100.0, 3.0);
  EXPECT_NEAR(static_cast<double>(borders[2]), 200.0, 3.0);
}

TEST(Bends, AKinkOfOneDegreeCutsALongEdge) {
  const Points points = edge(200, [](int i) { return i < 100 ? 0.0 : (i - 100) * 0.0175; });
  EXPECT_EQ(bends(points, {}).size(), 3U);
}

TEST(Bends, NoiseAloneDoesNotCut) {
  for (const double noise_px : {0.05, 0.1, 0.2, 0.3}) {
    const Points points = edge(
        300, [](int) { return 0.0; }, noise_px);
    EXPECT_THAT(bends(points, {}), ElementsAre(0, 300)) << noise_px;
  }
}

TEST(Bends, PartsKeepTheLeastLength) {
  const Points points = edge(
      30, [](int i) { return i < 5 ? 2.0 : 0.0; }, 0.0);
  for (const ExtractOptions options; const std::size_t border : bends(points, options)) {
    EXPECT_TRUE(border == 0 || border >= static_cast<std::size_t>(options.min_length_px)) << border;
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
