// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/roof_edge_extraction.h"

#include "evaluate/judge/quiet_pcl.h"
#include "reconstruct/geometry/check.h"

#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

template <typename PointT>
ScanEdges RoofEdgeExtraction<PointT>::compute() {
  check(input_ && initCompute(), "RoofEdgeExtraction: cloud = none, must be set and have points");
  std::vector<Eigen::Vector3d> points;
  points.reserve(indices_->size());
  for (const pcl::index_t i : *indices_) {
    points.push_back(
        (*input_)[static_cast<std::size_t>(i)].getVector3fMap().template cast<double>());
  }
  deinitCompute();
  if (!search_) return find_edges(points, options_);
  return find_edges(points, options_,
                    [this](std::span<const Eigen::Vector3d> x, std::size_t per_point) {
                      return searched_neighbours(x, per_point);
                    });
}

/// PCL's own order of points at nearly the same distance depends on the search and on rounding, so
/// all points up to the distance of the last neighbour are ranked again.
template <typename PointT>
PointNeighbours RoofEdgeExtraction<PointT>::searched_neighbours(
    std::span<const Eigen::Vector3d> points, std::size_t per_point) const {
  constexpr double kRounding = 1e-5;  // of PCL's squared distances in float, generously
  const QuietPcl quiet;
  const auto cloud = std::make_shared<pcl::PointCloud<PointT>>();
  for (const Eigen::Vector3d& x : points) {
    cloud->emplace_back();
    cloud->back().getVector3fMap() = x.cast<float>();
  }
  search_->setInputCloud(cloud);
  PointNeighbours neighbours(points.size(), per_point);
  pcl::Indices found;
  std::vector<float> squared_m2;
  std::vector<std::pair<double, std::uint32_t>> ranked;
  for (std::size_t i = 0; i < points.size(); ++i) {
    search_->nearestKSearch((*cloud)[i], static_cast<int>(per_point), found, squared_m2);
    check(found.size() == per_point, "setSearchMethod: search = ", search_->getName(),
          ", must find the points of the cloud, but does not");
    const double last_m = std::sqrt(*std::ranges::max_element(squared_m2));
    search_->radiusSearch((*cloud)[i], last_m * (1.0 + kRounding) + kRounding, found, squared_m2);
    ranked.clear();
    for (const pcl::index_t k : found) {
      const auto n = static_cast<std::uint32_t>(k);
      ranked.emplace_back((points[n] - points[i]).squaredNorm(), n);
    }
    std::ranges::sort(ranked);
    check(ranked.size() >= per_point, "setSearchMethod: search = ", search_->getName(),
          ", must be exact, but misses points within a radius");
    std::ranges::transform(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(per_point),
                           neighbours.of(i).begin(), [](const auto& r) { return r.second; });
  }
  return neighbours;
}

template class RoofEdgeExtraction<pcl::PointXYZ>;
template class RoofEdgeExtraction<pcl::PointXYZI>;
template class RoofEdgeExtraction<pcl::PointXYZL>;
template class RoofEdgeExtraction<pcl::PointNormal>;
template class RoofEdgeExtraction<pcl::PointXYZINormal>;

}  // namespace ridgeline::evaluate
