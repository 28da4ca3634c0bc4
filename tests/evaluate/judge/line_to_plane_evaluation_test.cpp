// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/line_to_plane_evaluation.h"

#include "tests/support/sampled_roof.h"

#include <gtest/gtest.h>
#include <pcl/point_types.h>

namespace ridgeline::evaluate {
namespace {

template <typename PointT>
class LineToPlaneEvaluationOf : public ::testing::Test {};
using PointTypes = ::testing::
    Types<pcl::PointXYZ, pcl::PointXYZI, pcl::PointXYZL, pcl::PointNormal, pcl::PointXYZINormal>;
TYPED_TEST_SUITE(LineToPlaneEvaluationOf, PointTypes);

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr cloud_of(const std::vector<Eigen::Vector3d>& points) {
  auto cloud = std::make_shared<pcl::PointCloud<PointT>>();
  for (const Eigen::Vector3d& x : points) {
    PointT p;
    p.getVector3fMap() = x.cast<float>();
    cloud->push_back(p);
  }
  return cloud;
}

JudgedLine eave_of(const test::SampledRoof& roof) {
  JudgedLine line;
  line.id = "eave";
  line.segment = {{0, roof.half_width_m, roof.eave_height_m},
                  {roof.length_m, roof.half_width_m, roof.eave_height_m}};
  return line;
}

TYPED_TEST(LineToPlaneEvaluationOf, GivesModelAndInliersOfThePlane) {
  const test::SampledRoof roof;
  const auto cloud = cloud_of<TypeParam>(roof.sample(6.0, 0.03, 1));
  LineToPlaneEvaluation<TypeParam> evaluation;
  evaluation.setInputCloud(cloud);
  evaluation.setInputLines({eave_of(roof)});
  const auto judged = evaluation.compute();
  ASSERT_EQ(judged.size(), 1U);
  ASSERT_EQ(judged[0].status, Status::kEvaluated) << judged[0].reason;

  const auto models = evaluation.getModelCoefficients(0);
  const auto inliers = evaluation.getInliers(0);
  ASSERT_EQ(models.size(), 1U);
  ASSERT_EQ(inliers.size(), 1U);
  ASSERT_EQ(models[0].values.size(), 4U);
  EXPECT_NEAR(models[0].values[2], roof.normal_z(), 0.01);
  EXPECT_GT(inliers[0].size(), 100U);
  for (const auto i : inliers[0]) {
    const auto& p = (*cloud)[static_cast<std::size_t>(i)];
    const float d = models[0].values[0] * p.x + models[0].values[1] * p.y +
                    models[0].values[2] * p.z + models[0].values[3];
    EXPECT_LE(std::abs(d), 0.1F + 1e-3F);
  }
}

TYPED_TEST(LineToPlaneEvaluationOf, UsesOnlyTheGivenIndices) {
  const test::SampledRoof roof;
  const auto cloud = cloud_of<TypeParam>(roof.sample(6.0, 0.03, 2));
  pcl::IndicesPtr ground_only(new pcl::Indices);
  for (int i = 0; i < static_cast<int>(cloud->size()); ++i) {
    if ((*cloud)[static_cast<std::size_t>(i)].z < 1.0F) ground_only->push_back(i);
  }
  LineToPlaneEvaluation<TypeParam> evaluation;
  evaluation.setInputCloud(cloud);
  evaluation.setIndices(ground_only);
  evaluation.setInputLines({eave_of(roof)});
  const auto judged = evaluation.compute();
  ASSERT_EQ(judged[0].status, Status::kEvaluated) << judged[0].reason;
  EXPECT_NEAR(*judged[0].mean_distance_m, roof.eave_height_m, 0.05);
  const auto inliers = evaluation.getInliers(0);
  for (const auto i : inliers.at(0)) {
    EXPECT_LT((*cloud)[static_cast<std::size_t>(i)].z, 1.0F);
  }
}

TYPED_TEST(LineToPlaneEvaluationOf, RefusesToRunWithoutACloud) {
  LineToPlaneEvaluation<TypeParam> evaluation;
  EXPECT_THROW(evaluation.compute(), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
