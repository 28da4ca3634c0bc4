// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/linked_line.h"

#include "tests/reconstruct/match/ok2011/painted_pair.h"
#include "tests/support/random.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

TEST(FitLine, GoesThroughPointsOnALine) {
  const Segment3 line{{1.0, 2.0, 3.0}, {4.0, 6.0, 3.0}};
  std::vector<Eigen::Vector3d> points;
  for (const double t : {1.0, 0.5, 0.25, 0.0}) points.push_back(point_at(line, t));
  const auto fitted = fit_line(points, 1.0);
  ASSERT_TRUE(fitted);
  // the line runs in the order of the points, from the end to the start
  EXPECT_LT((fitted->segment.start - line.end).norm(), 1e-12);
  EXPECT_LT((fitted->segment.end - line.start).norm(), 1e-12);
  EXPECT_LT(fitted->cov_m2.norm(), 1e-12);
}

TEST(FitLine, NeedsThreePointsInDifferentPlaces) {
  const Eigen::Vector3d x(1.0, 2.0, 3.0);
  EXPECT_FALSE(fit_line(std::vector<Eigen::Vector3d>{x, 2.0 * x}, 1.0));
  EXPECT_FALSE(fit_line(std::vector<Eigen::Vector3d>{x, x, x}, 1.0));
}

/// Normalised errors of the two ends across the line, 4 degrees of freedom.
double nees_of(const FittedLine& line, const Segment3& truth) {
  const Eigen::Vector3d u = (truth.end - truth.start).normalized();
  const Eigen::Vector3d v = u.unitOrthogonal();
  Eigen::Matrix<double, 6, 4> across = Eigen::Matrix<double, 6, 4>::Zero();
  for (const int end : {0, 1}) {
    across.block<3, 1>(3 * end, 2 * end) = v;
    across.block<3, 1>(3 * end, 2 * end + 1) = u.cross(v);
  }
  Eigen::Matrix<double, 6, 1> error;
  error << line.segment.start - truth.start, line.segment.end - truth.start;
  const Eigen::Vector4d e = across.transpose() * error;
  return e.dot((across.transpose() * line.cov_m2 * across).inverse() * e);
}

TEST(FitLine, CovarianceIsThatOfItsErrors) {
  const Segment3 truth{{0.0, 0.0, 5.0}, {6.0, 2.0, 6.0}};
  constexpr int kTrials = 2000;
  constexpr int kPoints = 60;
  test::Random random(1);
  double sum = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(kPoints);
    for (int i = 0; i < kPoints; ++i) {
      points.push_back(
          point_at(truth, static_cast<double>(i) / (kPoints - 1)) +
          Eigen::Vector3d(random.normal(0.02), random.normal(0.02), random.normal(0.1)));
    }
    const auto fitted = fit_line(points, 1.0);
    ASSERT_TRUE(fitted);
    sum += nees_of(*fitted, truth) / kTrials;
  }
  // the mean of 2000 chi-squares of 4 has sigma 0.063; the estimated scatter makes it 4 * 58 / 54
  EXPECT_NEAR(sum, 4.3, 0.3);
}

TEST(FitLine, FewerIndependentPointsMakeItLessCertain) {
  test::Random random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 20; ++i) points.emplace_back(i, random.normal(0.1), random.normal(0.1));
  const Matrix6d free = fit_line(points, 1.0)->cov_m2;
  const Matrix6d correlated = fit_line(points, 2.5)->cov_m2;
  EXPECT_LT((correlated - 2.5 * free).norm(), 1e-12);
}

TEST(LineThroughLinks, RunsTheWayOfTheLeftSegmentInWhicheverOrderTheFragmentsWereLinked) {
  constexpr double kGsd_m = 0.08;
  constexpr double kNear_m = 0.5;  // error of ends 12 m apart on an edge without blur
  test::PaintedPair pair({{-4.0, -6.0, 4.0, 6.0, 5.0}});
  const Segment3 edge{{-4.0, -6.0, 5.0}, {-4.0, 6.0, 5.0}};
  pair.add_segment(0, edge);
  pair.add_segment(1, {edge.start, {-4.0, -0.5, 5.0}});
  pair.add_segment(1, {{-4.0, 0.5, 5.0}, edge.end});
  for (const std::vector<int>& fragments : {std::vector{0, 1}, std::vector{1, 0}}) {
    const auto line = line_through_links(0, fragments, pair.searched(), kGsd_m);
    ASSERT_TRUE(line.has_value());
    EXPECT_LT((line->segment.start - edge.start).norm(), kNear_m) << fragments[0];
    EXPECT_LT((line->segment.end - edge.end).norm(), kNear_m) << fragments[0];
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
