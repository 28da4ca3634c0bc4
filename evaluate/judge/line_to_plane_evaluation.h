// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_lines.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>

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
/// Instantiated for PointXYZ, PointXYZI and PointXYZL. The sample consensus is PCL's; sums and
/// final fits run in double. The search structure is a grid of its own (PointGrid): it builds
/// twelve times faster than a kd-tree and answers corridors, not balls.
// NOLINTBEGIN(readability-identifier-naming): PCL's spelling, as PCL's users know it
template <typename PointT>
class LineToPlaneEvaluation : public pcl::PCLBase<PointT> {
 public:
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;

  /// Points in local coordinates, metres; non-finite points are left out. setIndices() restricts.
  void setInputCloud(const PointCloudConstPtr& cloud) override;
  void setInputLines(std::vector<JudgedLine> lines) { lines_ = std::move(lines); }

  /// MSAC by default.
  void setMethodType(SampleConsensus method) { options_.method = method; }
  /// Largest distance of a plane's point, as in pcl::SACSegmentation.
  void setDistanceThreshold(double threshold_m) { options_.inlier_distance_m = threshold_m; }
  void setMaxIterations(int iterations) { options_.max_iterations = iterations; }
  /// Half width of the corridor around a line, in plan.
  void setSearchHalfWidth(double half_width_m) { options_.corridor_half_width_m = half_width_m; }
  /// Size of the search grid's cells.
  void setSearchCellSize(double cell_m) { cell_m_ = cell_m; }
  void setOptions(const JudgeOptions& options) { options_ = options; }
  [[nodiscard]] const JudgeOptions& getOptions() const { return options_; }

  /// One judgement a line, in the order of the lines.
  /// Throws std::invalid_argument without a cloud or for an option out of its range.
  std::vector<LineEvaluation> compute();

  /// The planes of a line after compute(): values (nx, ny, nz, d), local frame, normal upwards.
  /// Throws std::out_of_range for a line that does not exist.
  [[nodiscard]] std::vector<pcl::ModelCoefficients> getModelCoefficients(std::size_t line) const;
  /// Their inliers, indices into the input cloud.
  [[nodiscard]] std::vector<pcl::Indices> getInliers(std::size_t line) const;

 private:
  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;
  using pcl::PCLBase<PointT>::initCompute;
  using pcl::PCLBase<PointT>::deinitCompute;

  JudgeOptions options_;
  double cell_m_ = 1.0;
  std::vector<JudgedLine> lines_;
  std::vector<JudgedResult> results_;
};
// NOLINTEND(readability-identifier-naming)

}  // namespace ridgeline::evaluate
