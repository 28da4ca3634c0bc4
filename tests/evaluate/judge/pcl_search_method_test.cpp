// SPDX-License-Identifier: BSD-3-Clause
// Whatever finds the points, the judge gives the same bits.
#include "evaluate/judge/line_to_plane_evaluation.h"
#include "reconstruct/geometry/interruption.h"
#include "tests/evaluate/judge/nadir_pair.h"
#include "tests/evaluate/judge/pcl_searches.h"
#include "tests/support/sampled_roof.h"

#include <gtest/gtest.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::evaluate {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Evaluation = LineToPlaneEvaluation<pcl::PointXYZ>;
using Search = pcl::search::Search<pcl::PointXYZ>;

/// The points of a house, doubled where tiles overlap, with some that are not finite and some high
/// above all others.
Cloud::Ptr cloud_with_faults() {
  auto cloud = std::make_shared<Cloud>();
  for (const Eigen::Vector3d& x : test::SampledRoof().sample(6.0, 0.034, 1)) {
    const Eigen::Vector3f p = x.cast<float>();
    cloud->emplace_back(p.x(), p.y(), p.z());
    if (p.x() > 6.0F) cloud->push_back(cloud->back());
    if (cloud->size() % 50 == 0) cloud->emplace_back(p.x(), p.y(), std::nanf(""));
    if (cloud->size() % 999 == 0) cloud->emplace_back(p.x(), p.y(), 70.0F);
  }
  cloud->is_dense = false;
  return cloud;
}

/// Borders and the ridge, true and displaced, with and without images, and lines that are refused.
std::vector<JudgedLine> lines_of(const test::SampledRoof& roof) {
  const double l = roof.length_m, w = roof.half_width_m, eave = roof.eave_height_m;
  std::vector<JudgedLine> lines;
  const auto add = [&](const Segment3& segment) {
    JudgedLine line;
    line.id = std::to_string(lines.size());
    line.segment = segment;
    lines.push_back(line);
    line.id += " seen";
    line.images = test::seen(segment);
    lines.push_back(line);
  };
  for (const double up_m : {0.0, 0.3}) {
    add({{0, 0, roof.ridge_height_m() + up_m}, {l, 0, roof.ridge_height_m() + up_m}});
    add({{0, w, eave + up_m}, {l, w, eave + up_m}});
    add({{0, -w, eave + up_m}, {l, -w, eave + up_m}});
    add({{0, 0, roof.ridge_height_m() + up_m}, {0, w, eave + up_m}});
  }
  add({{500, 500, 0}, {510, 500, 0}});  // no points
  JudgedLine far;
  far.id = "far";
  far.segment = {{-9e6, 0, 0}, {9e6, 1, 0}};
  lines.push_back(far);
  return lines;
}

void expect_same_bits(const LineEvaluation& a, const LineEvaluation& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.flags, b.flags);
  EXPECT_EQ(a.mean_distance_m, b.mean_distance_m);
  ASSERT_EQ(a.planes.size(), b.planes.size());
  for (std::size_t p = 0; p < a.planes.size(); ++p) {
    EXPECT_EQ(a.planes[p].id, b.planes[p].id);
    EXPECT_EQ(a.planes[p].plane.coeffs(), b.planes[p].plane.coeffs());
    EXPECT_EQ(a.planes[p].n_inliers, b.planes[p].n_inliers);
    EXPECT_EQ(a.planes[p].sigma_m, b.planes[p].sigma_m);
    EXPECT_EQ(a.planes[p].coverage, b.planes[p].coverage);
  }
}

void expect_same_bits_by_every_search(Evaluation& evaluation, std::size_t least_evaluated) {
  const auto lines = lines_of({});
  evaluation.setInputLines(lines);
  evaluation.setSearchMethod(nullptr);
  const auto expected = evaluation.compute();
  std::vector<std::vector<pcl::Indices>> expected_inliers;
  std::size_t n_evaluated = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    expected_inliers.push_back(evaluation.getInliers(i));
    n_evaluated += expected[i].status == Status::kEvaluated ? 1 : 0;
  }
  EXPECT_GE(n_evaluated, least_evaluated);
  for (const Search::Ptr& search : test::pcl_searches()) {
    evaluation.setSearchMethod(search);
    const auto judged = evaluation.compute();
    ASSERT_EQ(judged.size(), expected.size());
    for (std::size_t i = 0; i < judged.size(); ++i) {
      SCOPED_TRACE(search->getName() + ", line " + judged[i].id);
      expect_same_bits(judged[i], expected[i]);
      EXPECT_EQ(evaluation.getInliers(i), expected_inliers[i]);
    }
  }
}

TEST(SetSearchMethod, ChangesNoBitOfAResult) {
  Evaluation evaluation;
  evaluation.setInputCloud(cloud_with_faults());
  expect_same_bits_by_every_search(evaluation, 16);
}

TEST(SetSearchMethod, ChangesNoBitOfAResultOfIndices) {
  const Cloud::Ptr cloud = cloud_with_faults();
  auto indices = std::make_shared<pcl::Indices>();  // backwards, every third one left out
  for (auto i = static_cast<pcl::index_t>(cloud->size()); i-- > 0;) {
    if (i % 3 != 0) indices->push_back(i);
  }
  indices->insert(indices->end(), indices->begin(), indices->begin() + 500);
  Evaluation evaluation;
  evaluation.setInputCloud(cloud);
  evaluation.setIndices(indices);
  expect_same_bits_by_every_search(evaluation, 16);
}

TEST(SetSearchMethod, GivesTheSearchTheCloudAsItIsWhenComputing) {
  const auto search = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  const Cloud::Ptr cloud = cloud_with_faults();
  Evaluation evaluation;
  evaluation.setSearchMethod(search);
  evaluation.setInputCloud(cloud);
  evaluation.setInputLines({lines_of({})[2]});
  const double before_m = *evaluation.compute()[0].mean_distance_m;
  constexpr float kLift_m = 0.5F;
  for (pcl::PointXYZ& p : *cloud) p.z += kLift_m;
  const double after_m = *evaluation.compute()[0].mean_distance_m;
  constexpr double kTol_m = 1e-3;  // the sample consensus draws in another order
  EXPECT_NEAR(after_m - before_m, kLift_m * test::SampledRoof().normal_z(), 0.05 + kTol_m);
  EXPECT_EQ(search->getInputCloud(), cloud);
}

TEST(SetSearchMethod, RefusesAnIndexThatIsNoPoint) {
  const Cloud::Ptr cloud = cloud_with_faults();
  for (const pcl::index_t wrong : {-1, static_cast<int>(cloud->size())}) {
    Evaluation evaluation;
    evaluation.setInputCloud(cloud);
    evaluation.setIndices(std::make_shared<pcl::Indices>(pcl::Indices{0, 1, 2, wrong}));
    evaluation.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
    EXPECT_THROW(evaluation.compute(), std::invalid_argument) << wrong;
  }
}

TEST(LineToPlaneEvaluation, IsLeftWhenInterrupted) {
  Evaluation evaluation;
  evaluation.setInputCloud(cloud_with_faults());
  evaluation.setInputLines(lines_of({}));
  Interruption::request();
  EXPECT_THROW(evaluation.compute(), Interrupted);
  Interruption::clear();
  EXPECT_EQ(evaluation.compute().size(), lines_of({}).size());
}

TEST(LineToPlaneEvaluation, ForgetsTheResultsOfOtherLines) {
  Evaluation evaluation;
  evaluation.setInputCloud(cloud_with_faults());
  evaluation.setInputLines(lines_of({}));
  (void)evaluation.compute();
  EXPECT_NO_THROW((void)evaluation.getInliers(0));
  evaluation.setInputLines(lines_of({}));
  EXPECT_THROW((void)evaluation.getInliers(0), std::out_of_range);
}

}  // namespace
}  // namespace ridgeline::evaluate
