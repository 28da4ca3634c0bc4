// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/ball_cover.h"
#include "evaluate/judge/point_search.h"
#include "evaluate/judge/quiet_pcl.h"
#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>
#include <pcl/point_cloud.h>
#include <pcl/search/search.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// Finds the points near a line with any PCL search: pcl::search::KdTree, Octree, BruteForce. PCL
/// searches in balls, but the judge needs all heights within a corridor, so BallCover stacks balls
/// over the heights of the cloud. The index of a point is its position in `indices`.
template <typename PointT>
class PclPointSearch final : public PointSearch {
 public:
  using Search = pcl::search::Search<PointT>;
  using CloudConstPtr = typename pcl::PointCloud<PointT>::ConstPtr;

  /// Passes the cloud to `search`, which builds its structure. Non-finite points are ignored.
  /// Throws std::invalid_argument for a search that does not find the cloud's own points, such as
  /// pcl::search::OrganizedNeighbor with a cloud that is not organised.
  PclPointSearch(typename Search::Ptr search, CloudConstPtr cloud, pcl::IndicesConstPtr indices);

 protected:
  void visit_runs_near(const Segment2& segment,
                       double radius_m,
                       const std::function<void(Run)>& visit) const override;

 private:
  [[nodiscard]] Eigen::Vector3d position(pcl::index_t i) const {
    return (*cloud_)[static_cast<std::size_t>(i)].getVector3fMap().template cast<double>();
  }
  void find_within(const Ball& ball, pcl::Indices& found) const;

  typename Search::Ptr search_;
  CloudConstPtr cloud_;
  std::vector<std::uint32_t> place_in_indices_;  ///< by index into the cloud
  Eigen::AlignedBox3d extent_;                   ///< of the finite points
};

template <typename PointT>
PclPointSearch<PointT>::PclPointSearch(typename Search::Ptr search,
                                       CloudConstPtr cloud,
                                       pcl::IndicesConstPtr indices)
    : search_(std::move(search)), cloud_(std::move(cloud)), place_in_indices_(cloud_->size()) {
  std::optional<pcl::index_t> last_finite;
  // the loop runs backwards, so that a point that is listed twice gets its first position, as in
  // PointGrid
  for (std::size_t place = indices->size(); place-- > 0;) {
    const pcl::index_t i = (*indices)[place];
    check(i >= 0 && static_cast<std::size_t>(i) < cloud_->size(), "setIndices: index = ", i,
          ", must be one of the cloud's ", cloud_->size(), " points");
    place_in_indices_[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(place);
    if (!position(i).allFinite()) continue;
    extent_.extend(position(i));
    last_finite = i;
  }
  if (!last_finite) return;  // PCL builds no structure over an empty cloud
  const QuietPcl quiet;
  search_->setInputCloud(cloud_, indices);
  pcl::Indices found;
  constexpr double kSomewhere_m = 0.01;
  find_within({position(*last_finite), kSomewhere_m}, found);
  check(!found.empty(), "setSearchMethod: search = ", search_->getName(),
        ", must find the points of the cloud, but does not");
}

template <typename PointT>
void PclPointSearch<PointT>::find_within(const Ball& ball, pcl::Indices& found) const {
  // PCL compares in float; the margin covers the rounding of the centre and of the squares
  const double largest_m = extent_.min().cwiseAbs().cwiseMax(extent_.max().cwiseAbs()).maxCoeff();
  const double margin_m = 1e-6 * largest_m + 1e-5 * ball.radius_m;
  PointT centre;
  centre.getVector3fMap() = ball.centre.template cast<float>();
  std::vector<float> squared_distances;
  search_->radiusSearch(centre, ball.radius_m + margin_m, found, squared_distances);
}

template <typename PointT>
void PclPointSearch<PointT>::visit_runs_near(const Segment2& segment,
                                             double radius_m,
                                             const std::function<void(Run)>& visit) const {
  const QuietPcl quiet;
  const BallCover cover(segment, radius_m, extent_);
  pcl::Indices found;
  std::vector<Point> run;
  for (int i = 0; i < cover.size(); ++i) {
    find_within(cover.ball(i), found);
    run.clear();
    for (const pcl::index_t k : found) {
      const Point point{position(k), place_in_indices_[static_cast<std::size_t>(k)]};
      // balls overlap: a point is reported by one of them only
      if (cover.ball_of(point.x) == i) run.push_back(point);
    }
    visit(run);
  }
}

}  // namespace ridgeline::evaluate
