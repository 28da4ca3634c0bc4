// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/roof_planes/plane_lines.h"

#include "reconstruct/estimate/beyond/roof_planes/plane_intersection.h"
#include "tests/reconstruct/estimate/beyond/roof_planes/gable_surface.h"
#include "tests/reconstruct/support/finite_difference.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/nees.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::segment_of;

constexpr double kMaxAligned_deg = 10.0;

std::vector<ReconstructedLine> lines_of(const test::GableSurface& gable,
                                        const std::vector<ReconstructedLine>& known = {}) {
  return plane_lines(gable.pair(), gable.surface(), known, kMaxAligned_deg);
}

double distance_from_axis_m(const Segment3& axis, const Eigen::Vector3d& x) {
  const Eigen::Vector3d along = (axis.end - axis.start).normalized();
  return (x - axis.start).cross(along).norm();
}

ReconstructedLine known_line(const Segment3& segment) {
  ReconstructedLine line;
  line.segment_in_local = segment;
  return line;
}

TEST(PlaneLines, RidgeOfAGableIsWhereItsRoofPlanesMeet) {
  constexpr double kOfFloats_m = 2e-3;
  constexpr double kOfCells_m =
      1.5;  // cells of half a metre beside the verges hold both roof and ground
  for (const double azimuth_deg : {0.0, 20.0, 65.0, 90.0}) {
    const test::GableSurface gable(azimuth_deg);
    const std::vector<ReconstructedLine> lines = lines_of(gable);
    ASSERT_EQ(lines.size(), 1U) << azimuth_deg;  // eaves and verges, which are steps, give none
    const Segment3& found = segment_of(lines[0]);
    for (const Eigen::Vector3d& end : {found.start, found.end})
      EXPECT_LT(distance_from_axis_m(gable.ridge(), end), kOfFloats_m) << azimuth_deg;
    EXPECT_NEAR(length(found), length(gable.ridge()), kOfCells_m);
    EXPECT_STREQ(status_name(lines[0]), "planes");
    EXPECT_EQ(lines[0].other(), (Observation{1, -1}));
    const Segment2 seen = project(gable.pair().cameras()[1], found);
    EXPECT_LT((lines[0].other().px.start - seen.start).norm(), 1e-9);
    EXPECT_EQ(lines[0].line_class,
              azimuth_deg == 0.0 ? LineClass::kAligned : LineClass::kNotAligned);
  }
}

TEST(PlaneLines, NoneWhereLinesAreKnownAlongHalfOfIt) {
  const test::GableSurface gable(65.0);
  const Segment3 ridge = gable.ridge();
  const auto n_beside = [&](const Segment3& known) {
    return lines_of(gable, {known_line(known)}).size();
  };
  EXPECT_EQ(n_beside(ridge), 0U);
  EXPECT_EQ(n_beside({ridge.start, point_at(ridge, 0.6)}), 0U);
  EXPECT_EQ(n_beside({ridge.start, point_at(ridge, 0.4)}), 1U);
  // this line looks the same in the images, at the depth of the ground
  const Eigen::Vector3d below(0.0, 0.0, -1.0);
  EXPECT_EQ(n_beside({ridge.start + below, ridge.end + below}), 1U);
  // this line crosses the ridge
  const Eigen::Vector3d across(ridge.start.y(), -ridge.start.x(), 0.0);
  EXPECT_EQ(n_beside({midpoint(ridge) - across, midpoint(ridge) + across}), 1U);
  EXPECT_EQ(lines_of(gable, {ReconstructedLine{}}).size(), 1U);  // a line without geometry
}

TEST(PlaneLines, NoneOfPlanesThatHardlyBend) {
  EXPECT_EQ(lines_of(test::GableSurface(65.0, 0.25)).size(), 1U);
  EXPECT_EQ(lines_of(test::GableSurface(65.0, 0.05)).size(), 0U);
}

TEST(PlaneLines, CovarianceHoldsForPixelsThatErrTogether) {
  constexpr int kTrials = test::kIsSanitized ? 10 : 60;
  constexpr int kBlock_px = 10;
  const test::GableSurface gable(65.0);
  const Segment3 ridge = gable.ridge();
  test::Random random(5);
  double sum = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    cv::Mat of_block(gable.rectification().size / kBlock_px + cv::Size(1, 1), CV_64F);
    for (int i = 0; i < static_cast<int>(of_block.total()); ++i)
      of_block.at<double>(i / of_block.cols, i % of_block.cols) = random.normal(0.15);
    const Surface surface = gable.surface([&](int row, int column) {
      return of_block.at<double>(row / kBlock_px, column / kBlock_px);
    });
    const auto lines = plane_lines(gable.pair(), surface, {}, kMaxAligned_deg);
    ASSERT_EQ(lines.size(), 1U);
    sum += test::nees(lines[0], ridge);
  }
  // pixels err together in blocks; the stated covariance takes 100 to err together
  constexpr double kExpected = 4.0 * kBlock_px * kBlock_px / 100.0;
  EXPECT_NEAR(sum / kTrials, kExpected, test::chi_square_mean_band(4.0, kTrials));
}

TEST(PointOfPlanes, IsOnBothWithTheJacobianOfCentralDifferences) {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  constexpr double kSecondOrder = 1e-6;
  const test::GableSurface gable(30.0);
  const Rectification& r = gable.rectification();
  Vector6 planes;
  planes << 0.21, 0.05, 120.0, -0.13, 0.11, 150.0;
  const auto difference = [](const Vector6& p) -> Eigen::Vector3d {
    return p.head<3>() - p.tail<3>();
  };
  // the place on the intersection that is nearest to a fixed place
  const auto place = [&](const Vector6& p, const Eigen::Vector2d& near) -> Eigen::Vector2d {
    const Eigen::Vector3d q = difference(p);
    return near - q.dot(near.homogeneous()) / q.head<2>().squaredNorm() * q.head<2>();
  };
  const Eigen::Vector2d on_line = place(planes, {120.0, 80.0});
  const PointOfPlanes point = point_of_planes(r, planes.head<3>(), planes.tail<3>(), on_line);
  EXPECT_NEAR(r.disparity_px(point.x_in_local), planes.tail<3>().dot(on_line.homogeneous()), 1e-9);
  const auto at = [&](const Vector6& p) -> Eigen::Vector3d {
    const Eigen::Vector2d x = place(p, on_line);
    return r.point_in_local(x, p.head<3>().dot(x.homogeneous()));
  };
  const Eigen::Matrix<double, 3, 6> expected = test::central_differences<3, 6>(at, planes);
  EXPECT_LT((point.by_planes - expected).norm(), kSecondOrder * expected.norm());
}

}  // namespace
}  // namespace ridgeline::reconstruct
