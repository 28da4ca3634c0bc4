// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/find_edges.h"

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/search/search.h>

#include <cstddef>
#include <span>

namespace ridgeline::evaluate {

/// Finds the planes and the roof edges of a point cloud, in the manner of PCL's own classes:
///
///   ridgeline::evaluate::RoofEdgeExtraction<pcl::PointXYZ> extraction;
///   extraction.setInputCloud(cloud);  // local coordinates: PCL's floats cannot hold UTM
///   const ridgeline::evaluate::ScanEdges found = extraction.compute();
///
/// Instantiated for PointXYZ, PointXYZI, PointXYZL, PointNormal and PointXYZINormal. The cloud is
/// processed as a whole; results::edges_of_cloud() processes files of any size. docs/pcl.md has an
/// example.
// NOLINTBEGIN(readability-identifier-naming): PCL's spelling, as PCL's users know it
template <typename PointT>
class RoofEdgeExtraction : public pcl::PCLBase<PointT> {
 public:
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  /// The search for the nearest neighbours of a point: pcl::search::KdTree, Octree, BruteForce or
  /// any other exact search. compute() passes it the points, from which it then builds its
  /// structure. If none is set, or a null pointer, a grid is used. The results are bit-identical.
  void setSearchMethod(const SearchPtr& search) { search_ = search; }
  /// The search method; null if none was set.
  [[nodiscard]] const SearchPtr& getSearchMethod() const { return search_; }

  /// Whether the points are those of roofs alone, without ground: see ScanOptions::only_roofs.
  void setOnlyRoofs(bool only_roofs) { options_.only_roofs = only_roofs; }
  [[nodiscard]] bool getOnlyRoofs() const { return options_.only_roofs; }

  /// The result of find_edges() for the points of the cloud, or those of setIndices(). Throws
  /// std::invalid_argument if there is no cloud, or if the search method does not find the points.
  ScanEdges compute();

 private:
  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;
  using pcl::PCLBase<PointT>::initCompute;
  using pcl::PCLBase<PointT>::deinitCompute;

  [[nodiscard]] PointNeighbours searched_neighbours(std::span<const Eigen::Vector3d> points,
                                                    std::size_t per_point) const;

  ScanOptions options_;
  SearchPtr search_;
};
// NOLINTEND(readability-identifier-naming)

}  // namespace ridgeline::evaluate
