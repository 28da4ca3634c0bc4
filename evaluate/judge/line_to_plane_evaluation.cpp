// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/line_to_plane_evaluation.h"

#include "evaluate/judge/pcl_point_search.h"
#include "evaluate/judge/quiet_pcl.h"
#include "reconstruct/geometry/transformed.h"

#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

/// The point's normal, with unit length. A point without one gets an upright normal of curvature 1,
/// which has no effect.
template <typename PointNT>
PointNormals::Normal usable_normal(const PointNT& point) {
  const Eigen::Vector3d n(point.normal_x, point.normal_y, point.normal_z);
  const double length = n.norm();
  if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(point.curvature)) {
    return {0.0F, 0.0F, 1.0F, 1.0F};
  }
  const Eigen::Vector3f unit = (n / length).template cast<float>();
  return {unit.x(), unit.y(), unit.z(), std::clamp(point.curvature, 0.0F, 1.0F)};
}

}  // namespace

template <typename PointT, typename PointNT>
void LineToPlaneEvaluation<PointT, PointNT>::setInputCloud(const PointCloudConstPtr& cloud) {
  pcl::PCLBase<PointT>::setInputCloud(cloud);
  results_.clear();
}

template <typename PointT, typename PointNT>
std::unique_ptr<PointSearch> LineToPlaneEvaluation<PointT, PointNT>::point_search() const {
  if (search_) return std::make_unique<PclPointSearch<PointT>>(search_, input_, indices_);
  const auto x_in_local = [this](std::size_t i) -> Eigen::Vector3d {
    return (*input_)[static_cast<std::size_t>((*indices_)[i])]
        .getVector3fMap()
        .template cast<double>();
  };
  return std::make_unique<PointGrid>(PointGrid::build(indices_->size(), x_in_local, cell_m_));
}

template <typename PointT, typename PointNT>
PointNormals LineToPlaneEvaluation<PointT, PointNT>::point_normals() const {
  PointNormals normals;
  if (!normals_) return normals;
  check(normals_->size() == input_->size(), "setInputNormals: normals = ", normals_->size(),
        ", must be as many as the points of the cloud, ", input_->size());
  check(normal_weight_ >= 0.0 && normal_weight_ <= 1.0,
        "setNormalDistanceWeight: weight = ", normal_weight_, ", must be in [0, 1]");
  normals.weight = normal_weight_;
  normals.of_point.reserve(indices_->size());
  for (const pcl::index_t i : *indices_) {
    normals.of_point.push_back(usable_normal((*normals_)[static_cast<std::size_t>(i)]));
  }
  return normals;
}

template <typename PointT, typename PointNT>
std::vector<LineEvaluation> LineToPlaneEvaluation<PointT, PointNT>::compute() {
  const QuietPcl quiet;
  results_.clear();
  check(initCompute(), "LineToPlaneEvaluation: no input cloud, call setInputCloud() first");
  const std::unique_ptr<PointSearch> search = point_search();
  search->set_normals(point_normals());
  JudgeOptions options = options_;
  options.keep_points = true;
  results_ = judge_lines(*search, lines_, options);
  for (JudgedResult& result : results_) {
    for (auto& inliers : result.inliers) {
      for (std::uint32_t& i : inliers) i = static_cast<std::uint32_t>((*indices_)[i]);
    }
  }
  deinitCompute();
  return transformed(results_, &JudgedResult::evaluation);
}

template <typename PointT, typename PointNT>
std::vector<pcl::ModelCoefficients> LineToPlaneEvaluation<PointT, PointNT>::getModelCoefficients(
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

template <typename PointT, typename PointNT>
std::vector<pcl::Indices> LineToPlaneEvaluation<PointT, PointNT>::getInliers(
    std::size_t line) const {
  std::vector<pcl::Indices> planes;
  for (const auto& inliers : results_.at(line).inliers) {
    planes.emplace_back(inliers.begin(), inliers.end());
  }
  return planes;
}

template class LineToPlaneEvaluation<pcl::PointXYZ>;
template class LineToPlaneEvaluation<pcl::PointXYZI>;
template class LineToPlaneEvaluation<pcl::PointXYZL>;
template class LineToPlaneEvaluation<pcl::PointNormal>;
template class LineToPlaneEvaluation<pcl::PointXYZINormal>;

}  // namespace ridgeline::evaluate
