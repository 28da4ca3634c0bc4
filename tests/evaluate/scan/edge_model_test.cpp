// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/edge_model.h"

#include "reconstruct/geometry/degrees.h"
#include "tests/support/random.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline::evaluate {
namespace {

/// A plane through (0, y, 0) that falls to both sides of y with the slope, known by 400 points.
PlaneFit sloped_plane(double y_m, double slope_deg) {
  PlaneFit fit;
  const double slope_rad = slope_deg * kRadPerDeg;
  const Eigen::Vector3d n(0.0, std::sin(slope_rad), std::cos(slope_rad));
  fit.centroid = {0.0, y_m, -std::tan(slope_rad) * y_m};
  fit.plane = Plane3(n, fit.centroid);
  fit.axes << Eigen::Vector3d::UnitX(), n.cross(Eigen::Vector3d::UnitX());
  fit.n = 400;
  fit.spread_m2 = {400.0 * 9.0, 400.0 * 2.0};
  fit.sigma0_m = 0.03;
  return fit;
}

/// The plane with errors drawn from the covariance of its fit.
Plane3 disturbed(const PlaneFit& fit, test::Random& random) {
  const double shift_m = random.normal(fit.sigma0_m / std::sqrt(fit.n));
  const Eigen::Vector2d tilt(random.normal(fit.sigma0_m / std::sqrt(fit.spread_m2.x())),
                             random.normal(fit.sigma0_m / std::sqrt(fit.spread_m2.y())));
  const Eigen::Vector3d n = (fit.plane.normal() - fit.axes * tilt).normalized();
  return {n, Eigen::Vector3d(fit.centroid + shift_m * fit.plane.normal())};
}

TEST(ModelOfSeam, HasTheCovarianceOfTheIntersectionOfDisturbedPlanes) {
  // planes at 30 and 10 degrees: horizontal errors are three times as large as vertical ones
  constexpr int kTrials = 20000;
  constexpr double kTolerance = 0.06;  // of a standard deviation; its own is 0.5 %
  const PlaneFit a = sloped_plane(3.0, 30.0), b = sloped_plane(-3.0, -10.0);
  const Segment3 ridge{{-5.0, 0.0, 0.0}, {5.0, 0.0, 0.0}};
  const EdgeModel model = model_of_seam(ridge, a, b);
  const Eigen::Matrix<double, 6, 6> stated = model.covariance_of_ends(ridge, {0.0, 0.0});
  test::Random random(11);
  Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    const Plane3 pa = disturbed(a, random), pb = disturbed(b, random);
    Eigen::Matrix<double, 6, 1> e;
    for (const int end : {0, 1}) {
      const double x = end == 0 ? ridge.start.x() : ridge.end.x();
      Eigen::Matrix3d m;  // where the intersection passes the plane across the ridge at its end
      m << pa.normal().transpose(), pb.normal().transpose(), Eigen::RowVector3d::UnitX();
      const Eigen::Vector3d at = m.inverse() * Eigen::Vector3d(-pa.offset(), -pb.offset(), x);
      e.segment<3>(3 * end) = at - (end == 0 ? ridge.start : ridge.end);
    }
    sum += e * e.transpose() / kTrials;
  }
  for (const int i : {1, 2, 4, 5}) {
    EXPECT_NEAR(std::sqrt(stated(i, i) / sum(i, i)), 1.0, kTolerance) << i;
  }
  // both ends move together as far as the planes shift
  EXPECT_NEAR(stated(1, 4), sum(1, 4), kTolerance * std::sqrt(sum(1, 1) * sum(4, 4)));
  EXPECT_NEAR(stated(1, 2), sum(1, 2), kTolerance * std::sqrt(sum(1, 1) * sum(2, 2)));
}

TEST(ModelOfBorder, HasTheErrorsOfItsLineOutwardsAndOfItsPlaneAcross) {
  const PlaneFit plane = sloped_plane(0.0, 0.0);
  BorderLine line;
  line.covariance << 0.04, 0.0, 0.0, 0.0001;
  const Segment3 eave{{-5.0, 2.0, 0.0}, {5.0, 2.0, 0.0}};
  const Eigen::Matrix<double, 6, 6> stated =
      model_of_border(eave, Eigen::Vector3d::UnitY(), plane, line)
          .covariance_of_ends(eave, {0.25, 0.0});
  constexpr double kTolerance_m2 = 1e-12;
  EXPECT_NEAR(stated(0, 0), 0.25, kTolerance_m2);
  EXPECT_NEAR(stated(1, 1), 0.04 + 25.0 * 0.0001, kTolerance_m2);
  EXPECT_NEAR(stated(1, 4), 0.04 - 25.0 * 0.0001, kTolerance_m2);
  const double sigma_m = plane.sigma_at(eave.start);
  EXPECT_NEAR(std::sqrt(stated(2, 2)) / sigma_m, 1.0, 0.005);  // widened for 400 points
}

}  // namespace
}  // namespace ridgeline::evaluate
