// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/pcl_point_search.h"

#include "evaluate/judge/point_grid.h"
#include "tests/evaluate/judge/pcl_searches.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/organized.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

namespace ridgeline::evaluate {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Search = pcl::search::Search<pcl::PointXYZ>;

/// A cloud as far from the origin as local coordinates may be. It is steep, so that balls are
/// stacked, and every tenth point is not finite.
Cloud::Ptr cloud_on_a_hillside() {
  test::Random random(4);
  auto cloud = std::make_shared<Cloud>();
  for (int i = 0; i < 3000; ++i) {
    const auto x = static_cast<float>(random.uniform(5000, 5060));
    const auto y = static_cast<float>(random.uniform(-4060, -4000));
    const auto z = static_cast<float>(x - 4900.0F + random.uniform(0, 10));
    cloud->emplace_back(x, y, i % 10 == 0 ? std::nanf("") : z);
  }
  cloud->is_dense = false;
  return cloud;
}

pcl::IndicesPtr all_of(const Cloud& cloud) {
  auto indices = std::make_shared<pcl::Indices>(cloud.size());
  std::iota(indices->begin(), indices->end(), 0);
  return indices;
}

PointGrid grid_of_cloud(const Cloud& cloud, const pcl::Indices& indices) {
  return PointGrid::build(indices.size(), [&](std::size_t i) {
    return Eigen::Vector3d(
        cloud[static_cast<std::size_t>(indices[i])].getVector3fMap().cast<double>());
  });
}

/// How often each point was visited, for those within the radius.
std::vector<int> visits_within(const PointSearch& search,
                               const Segment2& segment,
                               double radius_m,
                               std::size_t n_points) {
  std::vector<int> visits(n_points, 0);
  search.visit_near(segment, radius_m, [&](const PointSearch::Point& p) {
    if (distance(segment, Eigen::Vector2d(p.x.head<2>())) <= radius_m) ++visits.at(p.index);
  });
  return visits;
}

TEST(PclPointSearch, VisitsThePointsThatTheGridVisitsOnce) {
  const Cloud::Ptr cloud = cloud_on_a_hillside();
  const pcl::IndicesPtr indices = all_of(*cloud);
  const PointGrid grid = grid_of_cloud(*cloud, *indices);
  for (const Search::Ptr& method : test::pcl_searches()) {
    const PclPointSearch<pcl::PointXYZ> search(method, cloud, indices);
    test::Random random(5);
    const auto place = [&] {
      return Eigen::Vector2d(random.uniform(4990, 5070), random.uniform(-4070, -3990));
    };
    for (int query = 0; query < 50; ++query) {
      const Segment2 segment{place(), place()};
      const double radius_m = random.uniform(0.1, 6.0);
      EXPECT_EQ(visits_within(search, segment, radius_m, cloud->size()),
                visits_within(grid, segment, radius_m, cloud->size()))
          << method->getName() << ", query " << query;
    }
  }
}

/// A corridor of 8 m in three layers of four balls, and points where four balls touch. The points
/// are as far from the centres as the balls reach, and floats do not hold the centres exactly.
TEST(PclPointSearch, LosesNoPointToFloats) {
  constexpr double kRadius_m = 4.0;
  test::Random random(9);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector2d start(random.uniform(5000, 5001), -4000.25);
    auto cloud = std::make_shared<Cloud>();
    for (const double s_m : {-4.0, 4.0, 12.0, 20.0, 28.0}) {
      for (const double t_m : {-kRadius_m, kRadius_m}) {
        for (const float z_m : {100.0F, 108.0F, 116.0F, 124.0F}) {
          cloud->emplace_back(static_cast<float>(start.x() + s_m),
                              static_cast<float>(start.y() + t_m), z_m);
        }
      }
    }
    const pcl::IndicesPtr indices = all_of(*cloud);
    const Segment2 segment{start, start + Eigen::Vector2d(24.0, 0.0)};
    const auto expected =
        visits_within(grid_of_cloud(*cloud, *indices), segment, kRadius_m, cloud->size());
    for (const Search::Ptr& method : test::pcl_searches()) {
      const PclPointSearch<pcl::PointXYZ> search(method, cloud, indices);
      EXPECT_EQ(visits_within(search, segment, kRadius_m, cloud->size()), expected)
          << method->getName() << ", trial " << trial;
    }
  }
}

TEST(PclPointSearch, CountsAsTheGridDoes) {
  const Cloud::Ptr cloud = cloud_on_a_hillside();
  const pcl::IndicesPtr indices = all_of(*cloud);
  const PointGrid grid = grid_of_cloud(*cloud, *indices);
  for (const Search::Ptr& method : test::pcl_searches()) {
    const PclPointSearch<pcl::PointXYZ> search(method, cloud, indices);
    test::Random random(6);
    for (int query = 0; query < 50; ++query) {
      const Eigen::Vector2d x(random.uniform(5000, 5060), random.uniform(-4060, -4000));
      EXPECT_EQ(search.count_within(x, 4.0), grid.count_within(x, 4.0)) << method->getName();
    }
    EXPECT_GT(search.count_within({5030, -4030}, 4.0), 10U);
    EXPECT_EQ(search.count_within({1e300, -1e300}, 4.0), 0U);
  }
}

TEST(PclPointSearch, GivesPlacesInTheIndicesInWhateverOrderTheyAre) {
  const Cloud::Ptr cloud = cloud_on_a_hillside();
  auto indices = std::make_shared<pcl::Indices>();
  for (int i = 2999; i > 0; i -= 3) indices->push_back(i);
  indices->push_back(2999);  // listed twice: its first place counts
  const Segment2 segment{{5000, -4030}, {5060, -4030}};
  const auto places = visits_within(grid_of_cloud(*cloud, *indices), segment, 5.0, indices->size());
  for (const Search::Ptr& method : test::pcl_searches()) {
    const PclPointSearch<pcl::PointXYZ> search(method, cloud, indices);
    search.visit_near(segment, 5.0, [&](const PointSearch::Point& p) {
      const auto i = static_cast<std::size_t>((*indices)[p.index]);
      EXPECT_EQ(p.x, (*cloud)[i].getVector3fMap().cast<double>());
      EXPECT_LT(p.index, indices->size() - 1);
      const bool is_within = distance(segment, Eigen::Vector2d(p.x.head<2>())) <= 5.0;
      EXPECT_EQ(places[p.index], is_within ? 1 : 0);
    });
  }
}

TEST(PclPointSearch, FindsNothingAmongPointsThatAreNotFinite) {
  auto cloud = std::make_shared<Cloud>();
  cloud->emplace_back(0.0F, 0.0F, HUGE_VALF);
  for (const Search::Ptr& method : test::pcl_searches()) {
    const PclPointSearch<pcl::PointXYZ> search(method, cloud, all_of(*cloud));
    EXPECT_EQ(search.count_within({0, 0}, 1e3), 0U) << method->getName();
  }
}

TEST(PclPointSearch, RejectsASearchThatDoesNotFindThePoints) {
  class Blind : public Search {
   public:
    Blind() : Search("Blind") {}
    int nearestKSearch(const pcl::PointXYZ&,
                       int,
                       pcl::Indices&,
                       std::vector<float>&) const override {
      return 0;
    }
    int radiusSearch(
        const pcl::PointXYZ&, double, pcl::Indices&, std::vector<float>&, unsigned) const override {
      return 0;
    }
  };
  const Cloud::Ptr cloud = cloud_on_a_hillside();
  try {
    const PclPointSearch<pcl::PointXYZ> search(std::make_shared<Blind>(), cloud, all_of(*cloud));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(
        error.what(),
        "setSearchMethod: search = Blind, must find the points of the cloud, but does not");
  }
}

TEST(PclPointSearch, RejectsAnOrganizedSearchOfACloudThatIsNotWithoutAMessageOfPcl) {
  const Cloud::Ptr cloud = cloud_on_a_hillside();
  const auto organized = std::make_shared<pcl::search::OrganizedNeighbor<pcl::PointXYZ>>();
  ::testing::internal::CaptureStderr();
  EXPECT_THROW(PclPointSearch<pcl::PointXYZ>(organized, cloud, all_of(*cloud)),
               std::invalid_argument);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace ridgeline::evaluate
