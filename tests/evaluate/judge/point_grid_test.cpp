// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/point_grid.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <limits>
#include <set>
#include <vector>

namespace ridgeline::evaluate {
namespace {

PointGrid grid_with_cells(const std::vector<Eigen::Vector3d>& points, double cell_m = 1.0) {
  return PointGrid::build(
      points.size(), [&](std::size_t i) { return points[i]; }, cell_m);
}

std::vector<Eigen::Vector3d> random_points(std::size_t n, double extent_m, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Eigen::Vector3d> points(n);
  for (Eigen::Vector3d& p : points) p = random.vector(0.0, extent_m);
  return points;
}

TEST(PointGrid, CountsAsPclKdTreeDoes) {
  // multiples of 2^-10 m: both float and double hold them exactly, so every count must agree
  std::vector<Eigen::Vector3d> points = random_points(20000, 60.0, 11);
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (Eigen::Vector3d& p : points) {
    p = (p * 1024.0).array().round() / 1024.0;
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
  }
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  const PointGrid grid = grid_with_cells(points);
  pcl::Indices indices;
  std::vector<float> squared;
  test::Random random(5);
  for (int query = 0; query < 500; ++query) {
    const double x = std::round(random.uniform(-3.0, 63.0) * 1024.0) / 1024.0;
    const double y = std::round(random.uniform(-3.0, 63.0) * 1024.0) / 1024.0;
    const double radius = 0.3 + 1e-4 * query;  // no distance of two such points falls on a radius
    tree.radiusSearch(pcl::PointXYZ(static_cast<float>(x), static_cast<float>(y), 0.0F), radius,
                      indices, squared);
    EXPECT_EQ(grid.count_within({x, y}, radius), indices.size()) << "query " << query;
  }
}

TEST(PointGrid, VisitsEveryPointNearASegmentOnce) {
  const std::vector<Eigen::Vector3d> points = random_points(5000, 40.0, 3);
  const PointGrid grid = grid_with_cells(points, 1.7);
  test::Random random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Segment2 segment{random.vector(-5.0, 45.0).head<2>(),
                           random.vector(-5.0, 45.0).head<2>()};
    std::multiset<std::uint32_t> visited;
    grid.visit_near(segment, 2.0, [&](const PointGrid::Point& p) {
      if (distance(segment, p.x.head<2>()) <= 2.0) visited.insert(p.index);
    });
    std::multiset<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (distance(segment, points[i].head<2>()) <= 2.0) expected.insert(i);
    }
    EXPECT_EQ(visited, expected) << "trial " << trial;
  }
}

TEST(PointGrid, LeavesOutPointsThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PointGrid grid = grid_with_cells({{0, 0, 0}, {nan, 0, 0}, {1, 1, HUGE_VAL}, {2, 2, 2}});
  EXPECT_EQ(grid.size(), 2U);
  EXPECT_EQ(grid.count_within({0, 0}, 10.0), 2U);
}

TEST(PointGrid, AnswersQueriesOfAnEmptyCloud) {
  EXPECT_EQ(grid_with_cells({}).count_within({0, 0}, 1e6), 0U);
}

TEST(PointGrid, KeepsItsSizeForTwoPointsFarApart) {
  const PointGrid grid = grid_with_cells({{0, 0, 0}, {1e7, 1e7, 0}});
  EXPECT_GT(grid.cell_m(), 1.0);
  EXPECT_EQ(grid.count_within({1e7, 1e7}, 1.0), 1U);
}

TEST(PointGrid, AnswersQueriesFarOutsideTheCloud) {
  const PointGrid grid = grid_with_cells(random_points(100, 10.0, 1));
  EXPECT_EQ(grid.count_within({1e300, -1e300}, 5.0), 0U);
}

TEST(PointGrid, RejectsACellSizeThatIsNotPositive) {
  EXPECT_THROW(grid_with_cells({{0, 0, 0}}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
