// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/line_to_plane_evaluation.h"

#include <pcl/point_types.h>

namespace ridgeline::evaluate {

template <typename PointT>
void LineToPlaneEvaluation<PointT>::setInputCloud(const PointCloudConstPtr& cloud) {
  pcl::PCLBase<PointT>::setInputCloud(cloud);
  results_.clear();
}

template <typename PointT>
std::vector<LineEvaluation> LineToPlaneEvaluation<PointT>::compute() {
  check(initCompute(), "LineToPlaneEvaluation: no input cloud, call setInputCloud() first");
  const auto x_in_local = [this](std::size_t i) -> Eigen::Vector3d {
    return (*input_)[static_cast<std::size_t>((*indices_)[i])]
        .getVector3fMap()
        .template cast<double>();
  };
  const PointGrid grid = PointGrid::build(indices_->size(), x_in_local, cell_m_);
  JudgeOptions options = options_;
  options.keep_points = true;
  results_ = judge_lines(grid, lines_, options);
  for (JudgedResult& result : results_) {
    for (auto& inliers : result.inliers) {
      for (std::uint32_t& i : inliers) i = static_cast<std::uint32_t>((*indices_)[i]);
    }
  }
  deinitCompute();
  std::vector<LineEvaluation> evaluations;
  evaluations.reserve(results_.size());
  for (const JudgedResult& result : results_) evaluations.push_back(result.evaluation);
  return evaluations;
}

template <typename PointT>
std::vector<pcl::ModelCoefficients> LineToPlaneEvaluation<PointT>::getModelCoefficients(
    std::size_t line) const {
  std::vector<pcl::ModelCoefficients> models;
  for (const JudgingPlane& p : results_.at(line).evaluation.planes) {
    pcl::ModelCoefficients model;
    for (const double value :
         {p.plane.normal().x(), p.plane.normal().y(), p.plane.normal().z(), p.plane.offset()}) {
      model.values.push_back(static_cast<float>(value));
    }
    models.push_back(model);
  }
  return models;
}

template <typename PointT>
std::vector<pcl::Indices> LineToPlaneEvaluation<PointT>::getInliers(std::size_t line) const {
  std::vector<pcl::Indices> planes;
  for (const auto& inliers : results_.at(line).inliers) {
    planes.emplace_back(inliers.begin(), inliers.end());
  }
  return planes;
}

template class LineToPlaneEvaluation<pcl::PointXYZ>;
template class LineToPlaneEvaluation<pcl::PointXYZI>;
template class LineToPlaneEvaluation<pcl::PointXYZL>;

}  // namespace ridgeline::evaluate
