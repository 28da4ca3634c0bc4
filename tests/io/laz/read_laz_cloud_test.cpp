// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_header.h"
#include "io/cloud/laz/copc.h"
#include "io/cloud/plan_mask.h"
#include "io/cloud/read_cloud.h"
#include "tests/io/laz/laz_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <span>

namespace ridgeline::io::laz {
namespace {

TEST(ReadCloud, GivesTheSameCloudForLazAsForLas) {
  const std::string name = "ign/test_data_77060_627760_LA93_IGN69";
  RIDGELINE_NEED_SHARED_FILE(name + ".laz");
  const PointCloud las = read_cloud({shared_file(name + ".las")});
  const PointCloud laz = read_cloud({shared_file(name + ".laz")});
  EXPECT_EQ(laz.n_read, 59'606U);
  EXPECT_EQ(laz.frame.origin_m, las.frame.origin_m);
  ASSERT_EQ(laz.points.size(), las.points.size());
  EXPECT_EQ(
      std::memcmp(laz.points.data(), las.points.data(), las.points.size() * sizeof(CloudPoint)), 0);
}

constexpr const char* kCopc = "las_samples/laspy_simple.copc.laz";

// The test file is in metres, its heights are in US survey feet.
std::vector<CloudPoint> points_inside(const PointCloud& cloud, const Eigen::AlignedBox3d& box) {
  std::vector<CloudPoint> inside;
  for (const CloudPoint& point : cloud.points) {
    const Eigen::Vector3d local(point.x, point.y, point.z);
    if (box.contains(cloud.frame.world_from_local(local))) inside.push_back(point);
  }
  return inside;
}

void expect_equal(const std::vector<CloudPoint>& a, const std::vector<CloudPoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  if (a.empty()) return;  // memcmp may not be given null
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(CloudPoint)), 0);
}

TEST(ReadCloud, GivesTheSamePointsOfACopcWindowAsACutOfTheWhole) {
  RIDGELINE_NEED_SHARED_FILE(kCopc);
  const PointCloud whole = read_cloud({shared_file(kCopc)});
  ASSERT_EQ(whole.n_read, 1065U);
  Eigen::AlignedBox3d box;
  for (const CloudPoint& point : whole.points) {
    box.extend(whole.frame.world_from_local({point.x, point.y, point.z}));
  }
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto random_point = [&]() -> Eigen::Vector3d {
    const Eigen::Vector3d share(uniform(rng), uniform(rng), uniform(rng));
    return box.min() + box.sizes().cwiseProduct(share);
  };
  for (int trial = 0; trial < 20; ++trial) {
    ReadOptions options;
    options.frame = whole.frame;
    Eigen::AlignedBox3d window_m;
    window_m.extend(random_point()).extend(random_point());
    const Eigen::Vector3d unit_m(whole.horizontal_unit_m, whole.horizontal_unit_m,
                                 whole.vertical_unit_m);
    options.bounds_in_file = Eigen::AlignedBox3d(window_m.min().cwiseQuotient(unit_m),
                                                 window_m.max().cwiseQuotient(unit_m));
    const PointCloud window = read_cloud({shared_file(kCopc)}, options);
    expect_equal(window.points, points_inside(whole, window_m));
    EXPECT_EQ(window.n_read, whole.n_read);
  }
}

TEST(ReadCloud, GivesTheSamePointsNearLinesOfACopcFileAsTheMaskKeepsOfTheWhole) {
  RIDGELINE_NEED_SHARED_FILE(kCopc);
  const PointCloud whole = read_cloud({shared_file(kCopc)});
  std::mt19937 rng(6);
  std::uniform_int_distribution<std::size_t> pick(0, whole.points.size() - 1);
  for (int trial = 0; trial < 10; ++trial) {
    const CloudPoint& a = whole.points[pick(rng)];
    const CloudPoint& b = whole.points[pick(rng)];
    const Segment2 segment{{a.x, a.y}, {b.x, b.y}};
    ReadOptions options;
    options.frame = whole.frame;
    options.near.emplace(std::span(&segment, 1), 20.0);
    std::vector<CloudPoint> expected;
    for (const CloudPoint& point : whole.points) {
      if (options.near->contains(point.x, point.y)) expected.push_back(point);
    }
    expect_equal(read_cloud({shared_file(kCopc)}, options).points, expected);
  }
}

TEST(PlanMask, OverlapsExactlyTheRectanglesWithMarkedCells) {
  const Segment2 segment{{10.0, 20.0}, {40.0, 35.0}};
  const PlanMask mask(std::span(&segment, 1), 3.0);
  const double cell = mask.cell_size_m();
  std::mt19937 rng(8);
  std::uniform_real_distribution<double> uniform(0.0, 55.0);
  int num_overlapping = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector2d min(uniform(rng), uniform(rng));
    const Eigen::Vector2d max = min + Eigen::Vector2d(uniform(rng), uniform(rng)) / 5.0;
    bool expected = false;  // samples closer than a cell meet every cell
    for (double x = min.x();; x = std::min(x + 0.5 * cell, max.x())) {
      for (double y = min.y();; y = std::min(y + 0.5 * cell, max.y())) {
        expected = expected || mask.contains(x, y);
        if (y >= max.y()) break;
      }
      if (x >= max.x()) break;
    }
    EXPECT_EQ(mask.overlaps(min, max), expected) << min.transpose() << " to " << max.transpose();
    num_overlapping += expected ? 1 : 0;
  }
  EXPECT_GT(num_overlapping, 100);
  EXPECT_LT(num_overlapping, 900);
  EXPECT_FALSE(PlanMask({}, 3.0).overlaps({-1e6, -1e6}, {1e6, 1e6}));
}

TEST(ReadCloud, LeavesOutTheFineLevelsOfACopcFile) {
  RIDGELINE_NEED_SHARED_FILE(kCopc);
  const std::vector<std::byte> file = read_file(shared_file(kCopc));
  const auto hierarchy = read_copc_hierarchy(file, parse_las_header(file, kCopc));
  ASSERT_TRUE(hierarchy);
  for (int level = 0; level <= 3; ++level) {
    std::uint64_t expected = 0;
    for (const CopcNode& node : hierarchy->nodes) {
      if (node.level <= level) expected += static_cast<std::uint64_t>(node.n_points);
    }
    ReadOptions options;
    options.max_resolution_m = 1.001 * hierarchy->spacing / (1 << level);
    const PointCloud cloud = read_cloud({shared_file(kCopc)}, options);
    EXPECT_EQ(cloud.n_read, expected) << level;
    for (const std::string& warning : cloud.warnings) {
      EXPECT_EQ(warning.find("header bounds"), std::string::npos) << warning;
    }
  }
}

}  // namespace
}  // namespace ridgeline::io::laz
