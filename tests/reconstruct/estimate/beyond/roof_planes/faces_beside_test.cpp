// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/roof_planes/faces_beside.h"

#include "tests/reconstruct/estimate/beyond/roof_planes/gable_surface.h"
#include "tests/reconstruct/support/finite_difference.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/nees.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

using test::covariance_of;
using test::right_segment_of;
using test::segment_of;

constexpr double kSigmaPlan_m = 0.02;
constexpr double kSigmaHeight_m = 0.5;
constexpr double kShared_px = 0.3;
constexpr double kOwn_px = 0.1;

/// A line whose edges tell its heights badly.
ReconstructedLine line_at(const Segment3& segment) {
  ReconstructedLine line;
  line.segment_in_local = segment;
  const Eigen::Array3d sigmas(kSigmaPlan_m, kSigmaPlan_m, kSigmaHeight_m);
  Vector6d variances;
  variances << sigmas.square(), sigmas.square();
  line.covariance_m2 = Matrix6d(variances.asDiagonal());
  return line;
}

Segment3 moved(const Segment3& segment, const Eigen::Vector3d& by) {
  return {segment.start + by, segment.end + by};
}

/// A piece of one verge that reaches neither ridge nor eave.
Segment3 verge(const test::GableSurface& gable) {
  const Segment3 ridge = gable.ridge();
  const Eigen::Vector3d top = ridge.end;
  const Eigen::Vector3d along = (ridge.end - ridge.start).normalized();
  const Eigen::Vector3d normal = gable.planes()[0].normal();
  const Eigen::Vector3d down = along.cross(normal).normalized();
  const double sign = down.z() < 0.0 ? 1.0 : -1.0;
  return {top + sign * 1.0 * down, top + sign * 5.0 * down};
}

double largest_distance_m(const Segment3& a, const Segment3& b) {
  return std::max((a.start - b.start).norm(), (a.end - b.end).norm());
}

TEST(FacesBeside, RidgesAndVergesComeToTheHeightOfTheirFaces) {
  constexpr double kFromFaces_m = 0.03;  // rest of 0.3 m; the line's first height weighs a little
  for (const double azimuth_deg : {0.0, 65.0, 90.0}) {
    const test::GableSurface gable(azimuth_deg);
    const PlaneFaces faces = plane_faces(gable.surface());
    for (const Segment3& truth : {gable.ridge(), verge(gable)}) {
      ReconstructedLine line = line_at(moved(truth, {0.0, 0.0, 0.3}));
      line.other_segment_in_local =
          Segment3{point_at(segment_of(line), 0.25), point_at(segment_of(line), 1.25)};
      adjust_to_faces_beside(gable.rectification(), faces, line);
      EXPECT_LT(largest_distance_m(segment_of(line), truth), kFromFaces_m) << azimuth_deg;
      EXPECT_LT(covariance_of(line)(2, 2), 0.1 * kSigmaHeight_m * kSigmaHeight_m);
      EXPECT_LT((right_segment_of(line).start - point_at(truth, 0.25)).norm(), kFromFaces_m);
      EXPECT_LT((right_segment_of(line).end - point_at(truth, 1.25)).norm(), kFromFaces_m);
    }
  }
}

TEST(FacesBeside, LinesThatTheFacesContradictStay) {
  const test::GableSurface gable(25.0);
  const PlaneFaces faces = plane_faces(gable.surface());
  const auto stays = [&](ReconstructedLine line) {
    const ReconstructedLine before = line;
    adjust_to_faces_beside(gable.rectification(), faces, line);
    return largest_distance_m(segment_of(line), segment_of(before)) == 0.0 &&
           line.covariance_m2 == before.covariance_m2;
  };
  EXPECT_FALSE(stays(line_at(gable.ridge())));
  EXPECT_TRUE(stays(line_at(moved(gable.ridge(), {0.0, 0.0, 4.0 * kSigmaHeight_m}))));
  ReconstructedLine without_covariance = line_at(moved(gable.ridge(), {0.0, 0.0, 0.3}));
  without_covariance.covariance_m2.reset();
  EXPECT_TRUE(stays(without_covariance));
  const Segment3 outside = moved(gable.ridge(), {1000.0, 0.0, 0.0});
  EXPECT_TRUE(stays(line_at(outside)));
}

TEST(FacesBeside, EaveAboveAStreetComesToTheNearerFace) {
  constexpr double kFromFaces_m = 0.03;
  const test::GableSurface gable(0.0);
  const Segment3 ridge = gable.ridge();
  const Eigen::Vector3d along = (ridge.end - ridge.start).normalized();
  const Eigen::Vector3d normal = gable.planes()[0].normal();
  Eigen::Vector3d down = along.cross(normal).normalized();
  if (down.z() > 0.0) down = -down;
  const double to_eave_m =
      test::GableSurface::kHalfWidth_m / Eigen::Vector2d(down.head<2>()).norm();
  const Segment3 eave = moved(ridge, to_eave_m * down);
  ReconstructedLine line = line_at(moved(eave, {0.0, 0.0, -0.3}));
  adjust_to_faces_beside(gable.rectification(), plane_faces(gable.surface()), line);
  EXPECT_LT(largest_distance_m(segment_of(line), eave), kFromFaces_m);
}

TEST(FacesBeside, NearerOfTwoFacesWinsALineBetweenThem) {
  const test::GableSurface gable(0.0);
  const Rectification& r = gable.rectification();
  const auto disparity_px = [&](double z_m) {
    return r.disparity_px(midpoint(gable.ridge()) + Eigen::Vector3d(0.0, 0.0, z_m));
  };
  constexpr double kLeft = 0.06;  // share of the step; the first height of the line weighs a little
  const double low_px = disparity_px(-0.6);
  const double high_px = disparity_px(0.6);
  constexpr int kCells = 40;
  PlaneFaces faces;
  faces.face_of_cell = cv::Mat(kCells, kCells, CV_32S, cv::Scalar(0));
  faces.face_of_cell.colRange(kCells / 2, kCells) = 1;
  const double step_px = PlaneFaces::kCell_px * kCells / 2 - 0.5;
  const Eigen::Matrix3d well_known = 1e-9 * Eigen::Matrix3d::Identity();
  for (const bool is_right_high : {false, true}) {
    const double left_px = is_right_high ? low_px : high_px;
    const double right_px = is_right_high ? high_px : low_px;
    faces.faces = {{{0.0, 0.0, left_px}, well_known, 1}, {{0.0, 0.0, right_px}, well_known, 1}};
    const auto at = [&](double y_px) {
      return r.point_in_local({step_px, y_px}, disparity_px(0.0));
    };
    ReconstructedLine line = line_at({at(50.0), at(150.0)});
    adjust_to_faces_beside(r, faces, line);
    EXPECT_NEAR(r.disparity_px(segment_of(line).start), high_px, kLeft * (high_px - low_px));
    EXPECT_NEAR(r.disparity_px(segment_of(line).end), high_px, kLeft * (high_px - low_px));
  }
}

/// The faces with errors as stated: of their planes, and of the distance of the line from them.
PlaneFaces with_errors(const PlaneFaces& faces, const Segment2& rectified, test::Random& random) {
  PlaneFaces result = faces;
  const Eigen::Vector2d u = along(rectified);
  for (PlaneFace& face : result.faces) {
    const Eigen::Vector3d normal(random.normal(1.0), random.normal(1.0), random.normal(1.0));
    face.plane += Eigen::LLT<Eigen::Matrix3d>(face.cov).matrixL() * normal;
    const double at_start = random.normal(kOwn_px);
    const double per_px = (random.normal(kOwn_px) - at_start) / length(rectified);
    face.plane.head<2>() += per_px * u;
    face.plane.z() += random.normal(kShared_px) + at_start - per_px * u.dot(rectified.start);
  }
  return result;
}

TEST(FacesBeside, CovarianceHoldsForErrorsAsStated) {
  constexpr int kTrials = 2000;
  constexpr double kFreedom = 4.0;
  const test::GableSurface gable(65.0);
  const Rectification& r = gable.rectification();
  PlaneFaces faces = plane_faces(gable.surface());
  constexpr double kWorse = 300.0;  // planes then err as much as lines are off them
  for (PlaneFace& face : faces.faces) face.cov *= kWorse;
  test::Random random(11);
  for (const Segment3& truth : {gable.ridge(), verge(gable)}) {
    double sum = 0.0;
    double sum_of_slopes = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const auto noisy = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        return x + Eigen::Vector3d(random.normal(kSigmaPlan_m), random.normal(kSigmaPlan_m),
                                   random.normal(kSigmaHeight_m));
      };
      ReconstructedLine line = line_at({noisy(truth.start), noisy(truth.end)});
      const Segment2 rectified{r.rectified(truth.start), r.rectified(truth.end)};
      adjust_to_faces_beside(r, with_errors(faces, rectified, random), line);
      sum += test::nees(line, truth);
      Vector6d rise = Vector6d::Zero();
      rise(2) = -1.0;
      rise(5) = 1.0;
      Vector6d error;
      error << segment_of(line).start - truth.start, segment_of(line).end - truth.end;
      sum_of_slopes += std::pow(rise.dot(error), 2.0) / rise.dot(covariance_of(line) * rise);
    }
    EXPECT_NEAR(sum / kTrials, kFreedom, test::chi_square_mean_band(kFreedom, kTrials));
    EXPECT_NEAR(sum_of_slopes / kTrials, 1.0, test::chi_square_mean_band(1.0, kTrials));
  }
}

TEST(PlaneMisfit, IsZeroOnThePlaneWithTheJacobiansOfCentralDifferences) {
  constexpr double kSecondOrder = 1e-6;
  const test::GableSurface gable(30.0);
  const Rectification& r = gable.rectification();
  const Eigen::Vector3d plane(0.21, -0.05, 120.0);
  const Eigen::Vector2d at_px(120.0, 80.0);
  const Eigen::Vector3d on_plane = r.point_in_local(at_px, plane.dot(at_px.homogeneous()));
  EXPECT_NEAR(plane_misfit(r, plane, on_plane).value_px, 0.0, 1e-9);

  const Eigen::Vector3d x = on_plane + Eigen::Vector3d(0.3, -0.2, 1.0);
  const PlaneMisfit misfit = plane_misfit(r, plane, x);
  using Value = Eigen::Matrix<double, 1, 1>;
  const Eigen::RowVector3d by_point = test::central_differences<1, 3>(
      [&](const Eigen::Vector3d& p) { return Value(plane_misfit(r, plane, p).value_px); }, x);
  const Eigen::RowVector3d by_plane = test::central_differences<1, 3>(
      [&](const Eigen::Vector3d& p) { return Value(plane_misfit(r, p, x).value_px); }, plane);
  EXPECT_LT((misfit.by_point - by_point).norm(), kSecondOrder * by_point.norm());
  EXPECT_LT((misfit.by_plane - by_plane).norm(), kSecondOrder * by_plane.norm());
}

}  // namespace
}  // namespace ridgeline::reconstruct
