// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/neighbours.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// A cluster of points over a sparse plane, with a wall of points above each other.
std::vector<Eigen::Vector3d> uneven_points() {
  test::Random random(3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 300; ++i)
    points.emplace_back(random.uniform(0.0, 40.0), random.uniform(0.0, 9.0), 0.0);
  for (int i = 0; i < 300; ++i)
    points.emplace_back(20.0 + random.uniform(0.0, 1.0), 4.0, random.uniform(0.0, 8.0));
  return points;
}

TEST(NearestNeighbours, AreThoseOfABruteForceSearch) {
  constexpr std::size_t kNumber = 12;
  const std::vector<Eigen::Vector3d> points = uneven_points();
  const PointNeighbours neighbours = nearest_neighbours(points, kNumber);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<std::pair<double, std::uint32_t>> all;
    for (std::size_t k = 0; k < points.size(); ++k)
      all.emplace_back((points[k] - points[i]).squaredNorm(), static_cast<std::uint32_t>(k));
    std::ranges::sort(all);
    for (std::size_t k = 0; k < kNumber; ++k) ASSERT_EQ(neighbours.of(i)[k], all[k].second) << i;
  }
}

TEST(NearestNeighbours, NeedMorePointsThanNeighbours) {
  const std::vector<Eigen::Vector3d> points(12, Eigen::Vector3d::Zero());
  EXPECT_THROW((void)nearest_neighbours(points, 12), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
