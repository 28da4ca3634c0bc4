// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/roof_edge_extraction.h"

#include "tests/support/made_points.h"

#include <gtest/gtest.h>
#include <pcl/point_types.h>
#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>

#include <cmath>
#include <memory>

namespace ridgeline::evaluate {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Extraction = RoofEdgeExtraction<pcl::PointXYZ>;

/// A gabled house; its points lie on a raster, where many distances are equal.
Cloud::Ptr raster_house() {
  auto cloud = std::make_shared<Cloud>();
  for (float x = -15.0F; x <= 15.0F; x += 0.5F) {
    for (float y = -15.0F; y <= 15.0F; y += 0.5F) {
      const bool on_roof = std::abs(x) <= 6.0F && std::abs(y) <= 10.0F;
      cloud->emplace_back(x, y, on_roof ? 8.0F - 0.5F * std::abs(x) : 0.0F);
    }
  }
  return cloud;
}

/// Another one, at random places.
Cloud::Ptr scanned_house() {
  auto cloud = std::make_shared<Cloud>();
  const std::vector<test::MadeBuilding> houses{test::make_building({})};
  for (const Eigen::Vector3d& x : test::scan(houses, {})) {
    cloud->emplace_back();
    cloud->back().getVector3fMap() = x.cast<float>();
  }
  return cloud;
}

void expect_same(const ScanEdges& a, const ScanEdges& b) {
  ASSERT_EQ(a.planes.size(), b.planes.size());
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    EXPECT_EQ(a.edges[i].segment.start, b.edges[i].segment.start);
    EXPECT_EQ(a.edges[i].segment.end, b.edges[i].segment.end);
    EXPECT_EQ(a.edges[i].covariance_m2, b.edges[i].covariance_m2);
  }
}

TEST(RoofEdgeExtraction, GivesTheSameBitsWithEverySearch) {
  for (const Cloud::Ptr& cloud : {raster_house(), scanned_house()}) {
    Extraction extraction;
    extraction.setInputCloud(cloud);
    const ScanEdges by_grid = extraction.compute();
    EXPECT_GE(by_grid.edges.size(), 4U);
    for (const Extraction::SearchPtr& search :
         {Extraction::SearchPtr(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>()),
          Extraction::SearchPtr(std::make_shared<pcl::search::Octree<pcl::PointXYZ>>(2.0)),
          Extraction::SearchPtr(std::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>())}) {
      extraction.setSearchMethod(search);
      expect_same(extraction.compute(), by_grid);
    }
  }
}

TEST(RoofEdgeExtraction, UsesOnlyThePointsOfTheIndices) {
  const Cloud::Ptr cloud = raster_house();
  Cloud::Ptr half = std::make_shared<Cloud>();
  auto indices = std::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    if ((*cloud)[i].y > 2.0F) continue;
    indices->push_back(static_cast<pcl::index_t>(i));
    half->push_back((*cloud)[i]);
  }
  Extraction of_part;
  of_part.setInputCloud(cloud);
  of_part.setIndices(indices);
  Extraction of_half;
  of_half.setInputCloud(half);
  expect_same(of_part.compute(), of_half.compute());
}

TEST(RoofEdgeExtraction, NeedsACloud) {
  EXPECT_THROW((void)Extraction().compute(), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
