// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/truth.h"

#include "apps/simulate/furniture.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ridgeline::simulate {
namespace {

TEST(ObserveLines, LinesOfALonelyHouseAreVisibleAndTheirPlanesHit) {
  const SyntheticScene scene = test::gabled_house(35.0, 15.0);
  const io::PointCloud cloud = test::cloud_of(scene, test::sample_grid(scene, 0.5));
  const std::vector<TruthLine> observed = observe_lines(scene, cloud);
  ASSERT_EQ(observed.size(), scene.lines.size());
  for (std::size_t i = 0; i < observed.size(); ++i) {
    EXPECT_EQ(observed[i].id, static_cast<int>(i));
    EXPECT_EQ(observed[i].visible_share, 1.0);
    ASSERT_EQ(observed[i].plane_returns.size(), scene.lines[i].plane_ids.size());
    for (const int returns : observed[i].plane_returns) EXPECT_GT(returns, 20);
  }
}

TEST(ObserveLines, CountsReturnsInTheCorridorOfTheLineOnly) {
  const SyntheticScene scene = test::gabled_house(35.0);
  io::PointCloud cloud;
  const int ridge = static_cast<int>(
      std::find_if(scene.lines.begin(), scene.lines.end(),
                   [](const auto& line) { return line.kind == LineKind::kRidge; }) -
      scene.lines.begin());
  const test::TopSurface top(scene);
  for (const double y : {21.0, 21.4, 21.6, 19.0}) {  // the ridge is at y = 20
    cloud.points.push_back(test::cloud_of(scene, {top.at({20.0, y})}).points.front());
  }
  cloud.points.push_back(cloud.points.front());
  cloud.points.back().z += 0.5;  // off the plane
  std::vector<int> returns =
      observe_lines(scene, cloud)[static_cast<std::size_t>(ridge)].plane_returns;
  std::sort(returns.begin(), returns.end());
  EXPECT_EQ(returns, (std::vector<int>{1, 2}));
}

TEST(ObserveLines, ATreeAboveHidesPartOfALine) {
  SyntheticScene scene = test::gabled_house(35.0);
  Random random({1});
  // the crown covers the ridge near its end, as no real tree would
  add_tree({14.0, 20.0, 0.0}, 3.0, 18.0, random, scene.mesh);
  const std::vector<TruthLine> observed = observe_lines(scene, {});
  const auto least = std::min_element(
      observed.begin(), observed.end(),
      [](const auto& a, const auto& b) { return a.visible_share < b.visible_share; });
  EXPECT_LT(least->visible_share, 0.8);
  EXPECT_GT(least->visible_share, 0.0);
  for (const TruthLine& line : observed) {
    for (const int returns : line.plane_returns) EXPECT_EQ(returns, 0);  // an empty cloud
  }
}

TEST(ObserveLines, RejectsACloudInAnotherFrame) {
  const SyntheticScene scene = test::flat_house();
  io::PointCloud cloud;
  cloud.frame.origin_m = {1.0, 0.0, 0.0};
  EXPECT_THROW(observe_lines(scene, cloud), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::simulate
