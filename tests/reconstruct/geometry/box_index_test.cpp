// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/box_index.h"

#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace ridgeline {
namespace {

using Box = Eigen::AlignedBox2d;

/// The places of the boxes within reach, by a look at all of them.
std::vector<std::size_t> expected(const std::vector<Box>& boxes, const Box& box, double reach) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < boxes.size(); ++k)
    if (!box.isEmpty() && !boxes[k].isEmpty() && boxes[k].exteriorDistance(box) <= reach)
      found.push_back(k);
  return found;
}

TEST(BoxIndex, FindsWhatASearchOfAllFinds) {
  test::Random random(3);
  std::vector<Box> boxes(1);  // an empty one
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d corner = random.vector(-100.0, 100.0).head<2>();
    boxes.emplace_back(corner, corner + random.vector(0.0, 40.0).head<2>());
  }
  const BoxIndex index(boxes);
  for (const Box& box : boxes) EXPECT_EQ(index.near(box, 3.0), expected(boxes, box, 3.0));
}

TEST(BoxIndex, TakesBoxesOfAnySizeAnywhere) {
  const auto box = [](double low, double high) {
    return Box(Eigen::Vector2d::Constant(low), Eigen::Vector2d::Constant(high));
  };
  const std::vector<Box> boxes{box(0, 1), box(-1e30, 1e30), box(1e20, 1e20), box(5, 5e6)};
  const BoxIndex index(boxes);
  for (const Box& asked : boxes) EXPECT_EQ(index.near(asked, 0.5), expected(boxes, asked, 0.5));
  EXPECT_EQ(index.near(box(-1e9, 1e9), 0.0), (std::vector<std::size_t>{0, 1, 3}));
}

TEST(BoxIndex, NeverFindsWhatIsNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Box endless(Eigen::Vector2d(0, 0), Eigen::Vector2d(kInfinity, 1));
  const BoxIndex index({endless});
  EXPECT_TRUE(index.near(Box(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)), 1.0).empty());
  EXPECT_TRUE(index.near(endless, 1.0).empty());
  EXPECT_TRUE(plan_box_of(std::vector<Eigen::Vector3d>{{0, 0, 0}, {0, NAN, 0}}).isEmpty());
}

}  // namespace
}  // namespace ridgeline
