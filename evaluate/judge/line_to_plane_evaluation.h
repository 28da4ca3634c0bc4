// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_lines.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// Judges 3D lines against the planes of a point cloud, in the manner of PCL's own classes:
///
///   ridgeline::evaluate::LineToPlaneEvaluation<pcl::PointXYZ> evaluation;
///   evaluation.setInputCloud(cloud);  // local coordinates: PCL's floats cannot hold UTM
///   evaluation.setInputLines(lines);
///   evaluation.setDistanceThreshold(0.10);
///   const auto judged = evaluation.compute();
///   const pcl::ModelCoefficients roof = evaluation.getModelCoefficients(0).front();
///
/// Instantiated for PointXYZ, PointXYZI, PointXYZL, PointNormal and PointXYZINormal. The sample
/// consensus is PCL's; sums and final fits run in double. docs/pcl.md has examples and
/// measurements.
///
/// Normals are used only after setInputNormals(), as in pcl::SACSegmentationFromNormals. This also
/// applies to a PointNormal cloud (PointNT is then PointT), since its normals are often empty.
// NOLINTBEGIN(readability-identifier-naming): PCL's spelling, as PCL's users know it
template <typename PointT,
          typename PointNT =
              std::conditional_t<pcl::traits::has_normal<PointT>::value, PointT, pcl::Normal>>
class LineToPlaneEvaluation : public pcl::PCLBase<PointT> {
 public:
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;
  using PointCloudNConstPtr = typename pcl::PointCloud<PointNT>::ConstPtr;
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  /// Points in local coordinates, metres; non-finite points are ignored. setIndices() restricts the
  /// points.
  void setInputCloud(const PointCloudConstPtr& cloud) override;
  void setInputLines(std::vector<JudgedLine> lines) {
    lines_ = std::move(lines);
    results_.clear();
  }

  /// The search for the points near a line: pcl::search::KdTree, Octree, BruteForce or any other
  /// exact search whose const queries may run in several threads. compute() passes it the cloud and
  /// the indices, from which it then builds its structure. If none is set, or a null pointer,
  /// PointGrid is used. The results are bit-identical.
  void setSearchMethod(const SearchPtr& search) { search_ = search; }
  /// The search method; null if none was set.
  [[nodiscard]] const SearchPtr& getSearchMethod() const { return search_; }

  /// Normals for the sample consensus, one per point of the cloud, of any length and either sign. A
  /// point whose normal is zero or not finite, or whose curvature is not finite, is rated by its
  /// distance only; a curvature below 0 is treated as 0, one above 1 as 1. A null pointer means no
  /// normals.
  void setInputNormals(const PointCloudNConstPtr& normals) { normals_ = normals; }
  [[nodiscard]] const PointCloudNConstPtr& getInputNormals() const { return normals_; }
  /// The weight, from 0 to 1, of the angle between a point's normal and the plane's (radians)
  /// relative to the distance (metres); 0.1 by default, as in PCL. See PointNormals.
  void setNormalDistanceWeight(double weight) { normal_weight_ = weight; }
  [[nodiscard]] double getNormalDistanceWeight() const { return normal_weight_; }

  /// The sample consensus; MSAC by default.
  void setMethodType(SampleConsensus method) { options_.method = method; }
  /// Largest distance of a point from its plane, as in pcl::SACSegmentation.
  void setDistanceThreshold(double threshold_m) { options_.inlier_distance_m = threshold_m; }
  void setMaxIterations(int iterations) { options_.max_iterations = iterations; }
  /// Half width of the corridor around a line, in plan.
  void setSearchHalfWidth(double half_width_m) { options_.corridor_half_width_m = half_width_m; }
  /// Cell size of PointGrid; no effect if a search method is set.
  void setSearchCellSize(double cell_m) { cell_m_ = cell_m; }
  void setOptions(const JudgeOptions& options) { options_ = options; }
  [[nodiscard]] const JudgeOptions& getOptions() const { return options_; }

  /// One judgement per line, in the order of the lines.
  /// Throws std::invalid_argument if there is no cloud, an option is out of its range, the number
  /// of normals differs from that of the points, or the search method does not find the cloud's
  /// points.
  std::vector<LineEvaluation> compute();

  /// The planes of a line after compute(): values (nx, ny, nz, d), local frame, normal upwards.
  /// Throws std::out_of_range for a line that does not exist.
  [[nodiscard]] std::vector<pcl::ModelCoefficients> getModelCoefficients(std::size_t line) const;
  /// The inliers of each plane of a line after compute(), as indices into the input cloud.
  [[nodiscard]] std::vector<pcl::Indices> getInliers(std::size_t line) const;

 private:
  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;
  using pcl::PCLBase<PointT>::initCompute;
  using pcl::PCLBase<PointT>::deinitCompute;

  [[nodiscard]] std::unique_ptr<PointSearch> point_search() const;
  [[nodiscard]] PointNormals point_normals() const;

  JudgeOptions options_;
  double cell_m_ = 1.0;
  SearchPtr search_;
  PointCloudNConstPtr normals_;
  double normal_weight_ = PointNormals{}.weight;
  std::vector<JudgedLine> lines_;
  std::vector<JudgedResult> results_;
};
// NOLINTEND(readability-identifier-naming)

}  // namespace ridgeline::evaluate
