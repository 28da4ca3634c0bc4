// SPDX-License-Identifier: BSD-3-Clause
// Normals in the sample consensus.
#include "evaluate/judge/line_to_plane_evaluation.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kRise_m = 0.19, kRun_m = 0.75;  // rise and run of a step
constexpr double kRoofLength_m = 10.0, kRoofHalfWidth_m = 4.0;
constexpr double kWeight = 0.4;  // at 0.1 the 14 degrees of the false slope cost 2.5 cm only

/// Terraces that go up along y. No point is farther than half a rise from a slope through all of
/// them, so by distances alone this slope beats every terrace.
double terrace_m(double y) { return kRise_m * std::floor(y / kRun_m + 0.5); }

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr terraces() {
  test::Random random(2);
  auto cloud = std::make_shared<pcl::PointCloud<PointT>>();
  for (int i = 0; i < 8000; ++i) {
    const double x = random.uniform(-kRoofHalfWidth_m, kRoofLength_m + kRoofHalfWidth_m);
    const double y = random.uniform(-kRoofHalfWidth_m, kRoofHalfWidth_m);
    PointT p;
    p.getVector3fMap() =
        Eigen::Vector3d(x, y, terrace_m(y) + random.normal(0.01)).template cast<float>();
    cloud->push_back(p);
  }
  return cloud;
}

/// A line along the outer edge of the step at height 0.
JudgedLine edge_of_a_step() {
  JudgedLine line;
  line.id = "edge";
  line.segment = {{0, 0.5 * kRun_m, 0}, {kRoofLength_m, 0.5 * kRun_m, 0}};
  return line;
}

template <typename NormalT>
typename pcl::PointCloud<NormalT>::Ptr upright_normals(std::size_t count) {
  NormalT up;
  up.normal_z = 1.0F;
  return std::make_shared<pcl::PointCloud<NormalT>>(static_cast<std::uint32_t>(count), 1U, up);
}

double slope_deg(const LineEvaluation& line) {
  return slope_rad(line.planes.at(0).plane) * 180.0 / std::numbers::pi;
}

template <typename PointT>
LineToPlaneEvaluation<PointT> evaluation_of(
    const typename pcl::PointCloud<PointT>::ConstPtr& cloud) {
  LineToPlaneEvaluation<PointT> evaluation;
  evaluation.setInputCloud(cloud);
  evaluation.setInputLines({edge_of_a_step()});
  JudgeOptions options;
  options.corridor_half_width_m = kRoofHalfWidth_m;  // several terraces on each side
  options.side_gap_m =
      0.0;  // a terrace is not much wider than the narrowest plane that is judged by
  options.place_sigma_m = 0.05;  // terraces lie nearer to each other than the default tells apart
  evaluation.setOptions(options);
  evaluation.setNormalDistanceWeight(kWeight);
  return evaluation;
}

TEST(SetInputNormals, TellsALevelTerraceFromTheSlopeThroughAll) {
  const auto cloud = terraces<pcl::PointXYZ>();
  auto evaluation = evaluation_of<pcl::PointXYZ>(cloud);
  const LineEvaluation without = evaluation.compute()[0];
  evaluation.setInputNormals(upright_normals<pcl::Normal>(cloud->size()));
  const LineEvaluation with = evaluation.compute()[0];

  const double false_slope_deg = std::atan(kRise_m / kRun_m) * 180.0 / std::numbers::pi;
  constexpr double kTol_deg = 1.5;  // the slope's ends lie on steps
  ASSERT_EQ(without.status, Status::kEvaluated) << without.reason;
  EXPECT_NEAR(slope_deg(without), false_slope_deg, kTol_deg);
  ASSERT_EQ(with.status, Status::kEvaluated) << with.reason;
  EXPECT_NEAR(slope_deg(with), 0.0, kTol_deg);
}

template <typename PointT>
class NormalsOfACloudOf : public ::testing::Test {};
using TypesWithNormals = ::testing::Types<pcl::PointNormal, pcl::PointXYZINormal>;
TYPED_TEST_SUITE(NormalsOfACloudOf, TypesWithNormals);

TYPED_TEST(NormalsOfACloudOf, TakePartOnlyIfTheyAreSet) {
  const auto cloud = terraces<TypeParam>();
  for (TypeParam& p : *cloud) p.getNormalVector3fMap() = Eigen::Vector3f::UnitZ();
  auto plain = evaluation_of<pcl::PointXYZ>(terraces<pcl::PointXYZ>());
  auto evaluation = evaluation_of<TypeParam>(cloud);
  EXPECT_EQ(evaluation.compute()[0].planes.at(0).plane.coeffs(),
            plain.compute()[0].planes.at(0).plane.coeffs());

  evaluation.setInputNormals(cloud);
  plain.setInputNormals(upright_normals<pcl::Normal>(cloud->size()));
  EXPECT_EQ(evaluation.compute()[0].planes.at(0).plane.coeffs(),
            plain.compute()[0].planes.at(0).plane.coeffs());
  EXPECT_LT(slope_deg(evaluation.compute()[0]), 1.5);
}

TEST(SetInputNormals, LeavesAPointWithoutAUsableNormalToItsDistance) {
  const auto cloud = terraces<pcl::PointXYZ>();
  auto evaluation = evaluation_of<pcl::PointXYZ>(cloud);
  const auto without = evaluation.compute()[0].planes.at(0).plane.coeffs();
  const float nan = std::nanf("");
  for (const pcl::Normal& useless :
       {pcl::Normal(0, 0, 0), pcl::Normal(nan, 0, 1), pcl::Normal(0, HUGE_VALF, 0),
        pcl::Normal(0, 0, 1, nan), pcl::Normal(0, 0, 1, 1)}) {
    evaluation.setInputNormals(std::make_shared<pcl::PointCloud<pcl::Normal>>(
        static_cast<std::uint32_t>(cloud->size()), 1U, useless));
    EXPECT_EQ(evaluation.compute()[0].planes.at(0).plane.coeffs(), without) << useless;
  }
}

TEST(SetInputNormals, TakesNormalsOfAnyLengthAndEitherSign) {
  const auto cloud = terraces<pcl::PointXYZ>();
  auto evaluation = evaluation_of<pcl::PointXYZ>(cloud);
  const auto normals = upright_normals<pcl::Normal>(cloud->size());
  evaluation.setInputNormals(normals);
  const auto expected = evaluation.compute()[0].planes.at(0).plane.coeffs();
  for (std::size_t i = 0; i < normals->size(); ++i) {
    (*normals)[i].normal_z = i % 2 == 0 ? -1e-30F : 1e-30F;  // the square is no float
  }
  EXPECT_EQ(evaluation.compute()[0].planes.at(0).plane.coeffs(), expected);
}

TEST(SetInputNormals, FollowsTheIndices) {
  const auto cloud = terraces<pcl::PointXYZ>();
  const auto normals = upright_normals<pcl::Normal>(cloud->size());
  // the search gets the second half backwards; the normals of the first half are wrong
  auto indices = std::make_shared<pcl::Indices>();
  for (std::size_t i = cloud->size(); i-- > cloud->size() / 2;) {
    indices->push_back(static_cast<pcl::index_t>(i));
  }
  std::fill_n(normals->begin(), cloud->size() / 2, pcl::Normal(1, 0, 0));
  auto evaluation = evaluation_of<pcl::PointXYZ>(cloud);
  evaluation.setIndices(indices);
  evaluation.setInputNormals(normals);
  const LineEvaluation line = evaluation.compute()[0];
  ASSERT_EQ(line.status, Status::kEvaluated) << line.reason;
  EXPECT_LT(slope_deg(line), 1.5);
}

TEST(SetInputNormals, HasNoEffectOnceTakenBack) {
  const auto cloud = terraces<pcl::PointXYZ>();
  auto evaluation = evaluation_of<pcl::PointXYZ>(cloud);
  const auto without = evaluation.compute()[0].planes.at(0).plane.coeffs();
  evaluation.setInputNormals(upright_normals<pcl::Normal>(cloud->size()));
  EXPECT_NE(evaluation.compute()[0].planes.at(0).plane.coeffs(), without);
  evaluation.setInputNormals(nullptr);
  EXPECT_EQ(evaluation.compute()[0].planes.at(0).plane.coeffs(), without);
}

TEST(SetInputNormals, RejectsAnotherNumberThanThatOfThePoints) {
  const auto cloud = terraces<pcl::PointXYZ>();
  auto evaluation = evaluation_of<pcl::PointXYZ>(cloud);
  evaluation.setInputNormals(upright_normals<pcl::Normal>(7));
  EXPECT_THROW(evaluation.compute(), std::invalid_argument);
}

TEST(SetNormalDistanceWeight, RejectsWhatIsNotAShare) {
  const auto cloud = terraces<pcl::PointXYZ>();
  auto evaluation = evaluation_of<pcl::PointXYZ>(cloud);
  evaluation.setInputNormals(upright_normals<pcl::Normal>(cloud->size()));
  for (const double weight : {-0.1, 1.1, std::nan("")}) {
    evaluation.setNormalDistanceWeight(weight);
    EXPECT_THROW(evaluation.compute(), std::invalid_argument) << weight;
  }
}

}  // namespace
}  // namespace ridgeline::evaluate
