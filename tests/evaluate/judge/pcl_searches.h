// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>
#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>

#include <memory>
#include <vector>

namespace ridgeline::test {

/// One of each kind of search of PCL that the judge takes.
inline std::vector<pcl::search::Search<pcl::PointXYZ>::Ptr> pcl_searches() {
  constexpr double kResolution_m = 2.0;
  return {std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(),
          std::make_shared<pcl::search::Octree<pcl::PointXYZ>>(kResolution_m),
          std::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>()};
}

}  // namespace ridgeline::test
