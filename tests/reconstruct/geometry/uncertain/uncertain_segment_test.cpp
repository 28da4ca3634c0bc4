// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include "reconstruct/geometry/uncertain/conditioning.h"
#include "tests/reconstruct/support/stereo_scene.h"
#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ridgeline {
namespace {

constexpr double kUncertainTol = 1e-12;

UncertainSegment2 horizontal() {
  return {.segment = {{-50, 0}, {50, 0}},
          .centroid_px = {0, 0},
          .sigma_q_px = 0.2,
          .sigma_phi_rad = 0.003,
          .sigma_e_px = 1.5};
}

/// Variance of the distance of the line from a point on it.
double variance_across(const UncertainLine2& line, const Eigen::Vector2d& x) {
  const Eigen::Vector3d h = x.homogeneous();
  return h.dot(line.cov * h) / line.mean.head<2>().squaredNorm();
}

/// Variance of the direction of a line through the origin.
double variance_of_direction(const UncertainLine2& line) {
  return line.cov(0, 0) / line.mean.head<2>().squaredNorm();
}

TEST(LineOfEnds, HasTheirVarianceAtBothEndsAndHalfOfItInTheMiddle) {
  const UncertainSegment2 ends = line_of_ends({{-50, 0}, {50, 0}}, 0.3);
  const UncertainLine2 line = uncertain_line(ends, LineCovariance::kCentroid);
  EXPECT_NEAR(variance_across(line, {-50, 0}), 0.09, kUncertainTol);
  EXPECT_NEAR(variance_across(line, {50, 0}), 0.09, kUncertainTol);
  EXPECT_NEAR(variance_across(line, {0, 0}), 0.045, kUncertainTol);
}

TEST(UncertainLine, IsTheJoinOfTheEndpoints) {
  for (const LineCovariance form : {LineCovariance::kCentroid, LineCovariance::kEq1}) {
    const UncertainLine2 line = uncertain_line({{{1, 2}, {4, 6}}, {2.5, 4}, 0.1, 0.01, 1.0}, form);
    const Eigen::Vector3d expected =
        Eigen::Vector3d(1, 2, 1).cross(Eigen::Vector3d(4, 6, 1)).normalized();
    EXPECT_NEAR((line.mean - expected).norm(), 0.0, kUncertainTol);
  }
}

TEST(UncertainLine, CentroidFormStatesItsParametersExactly) {
  const UncertainLine2 line = uncertain_line(horizontal(), LineCovariance::kCentroid);
  EXPECT_NEAR(variance_across(line, {0, 0}), 0.04, kUncertainTol);
  EXPECT_NEAR(variance_of_direction(line), 9e-6, kUncertainTol);
  EXPECT_NEAR(variance_across(line, {100, 0}), 0.04 + 100 * 100 * 9e-6, kUncertainTol);
}

TEST(UncertainLine, Eq1FormHasIndependentEndpoints) {
  const UncertainLine2 line = uncertain_line(horizontal(), LineCovariance::kEq1);
  const double endpoint_variance = 0.04 + 50 * 50 * 9e-6;
  EXPECT_NEAR(variance_across(line, {0, 0}), endpoint_variance / 2, kUncertainTol);
  EXPECT_NEAR(variance_of_direction(line), 2 * endpoint_variance / 1e4, kUncertainTol);
  EXPECT_NEAR(variance_across(line, {50, 0}), endpoint_variance, kUncertainTol);
}

TEST(UncertainLine, Eq1DoublesTheVarianceAcrossARegressionLine) {
  // N edge pixels at unit spacing: sigma_q^2 = s^2 / N, sigma_phi^2 = 12 s^2 / (N^3 - N)
  constexpr double kPixels = 100;
  UncertainSegment2 s = horizontal();
  s.segment = {{-49.5, 0}, {49.5, 0}};
  s.sigma_q_px = 0.3 / std::sqrt(kPixels);
  s.sigma_phi_rad = 0.3 * std::sqrt(12 / (kPixels * kPixels * kPixels - kPixels));
  const UncertainLine2 eq1 = uncertain_line(s, LineCovariance::kEq1);
  const UncertainLine2 centroid = uncertain_line(s, LineCovariance::kCentroid);
  const Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  EXPECT_NEAR(variance_across(eq1, origin) / variance_across(centroid, origin), 1.97, 0.01);
  EXPECT_NEAR(variance_of_direction(eq1) / variance_of_direction(centroid), 0.67, 0.01);
}

TEST(UncertainLine, CentroidFormIsEq1WithTheCorrelationOfTheEndpoints) {
  test::Random random(81);
  for (int trial = 0; trial < 1000; ++trial) {
    const Segment2 segment{random.vector(-1, 1).head<2>(), random.vector(-1, 1).head<2>()};
    if (length(segment) < 0.1) continue;
    const double t = random.uniform(0, 1);
    const UncertainSegment2 s{segment, (1 - t) * segment.start + t * segment.end, 0.01, 0.02, 0.0};
    // q and phi move the endpoints along the normal by (1, -a) and (1, b)
    const Eigen::Vector2d along = (segment.end - segment.start).normalized();
    const Eigen::Vector3d normal(-along.y(), along.x(), 0.0);
    const double a = t * length(segment);
    const double b = (1 - t) * length(segment);
    const double q2 = s.sigma_q_px * s.sigma_q_px;
    const double phi2 = s.sigma_phi_rad * s.sigma_phi_rad;
    const Eigen::Matrix3d cov_xy = (q2 - a * b * phi2) * normal * normal.transpose();
    const Eigen::Matrix3d sx = skew(segment.start.homogeneous());
    const Eigen::Matrix3d sy = skew(segment.end.homogeneous());
    const Uncertain<3> independent =
        cross({segment.start.homogeneous(), (q2 + a * a * phi2) * normal * normal.transpose()},
              {segment.end.homogeneous(), (q2 + b * b * phi2) * normal * normal.transpose()});
    const Eigen::Matrix3d mixed = sy * cov_xy * sx.transpose();
    const UncertainLine2 exact = spherically_normalised(
        UncertainLine2{independent.mean, independent.cov - mixed - mixed.transpose()});
    const UncertainLine2 centroid = uncertain_line(s, LineCovariance::kCentroid);
    EXPECT_NEAR((exact.mean - centroid.mean).norm(), 0.0, kUncertainTol);
    EXPECT_NEAR((exact.cov - centroid.cov).norm(), 0.0, kUncertainTol);
  }
}

TEST(UncertainLine, HasTheSpreadOfRandomLines) {
  constexpr int kDraws = 20000;
  constexpr double kRelativeTol = 0.05;  // 5 times the standard error of a variance of 20000 draws
  test::Random random(82);
  const Segment2 truth{{-40, 30}, {35, -20}};
  const test::Noise noise;
  const ImageConditioning image{.centre_px = {0, 0}, .scale_px = 50};
  const UncertainLine2 stated =
      uncertain_line(test::exact(truth, noise), LineCovariance::kCentroid, image);
  const Eigen::Matrix<double, 3, 2> basis = tangent_basis<3>(stated.mean);
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const UncertainLine2 line =
        uncertain_line(test::noisy(truth, noise, random), LineCovariance::kCentroid, image);
    const Eigen::Vector2d deviation = basis.transpose() * line.mean;
    sum += deviation * deviation.transpose();
  }
  const Eigen::Matrix2d expected = basis.transpose() * stated.cov * basis;
  EXPECT_LT((sum / kDraws - expected).norm(), kRelativeTol * expected.norm());
}

TEST(UncertainLine, InConditionedCoordinatesIsTheTransformedLine) {
  const ImageConditioning image{.centre_px = {300, 200}, .scale_px = 250};
  const UncertainSegment2 s{{{310, 220}, {420, 260}}, {365, 240}, 0.1, 0.004, 1.0};
  for (const LineCovariance form : {LineCovariance::kCentroid, LineCovariance::kEq1}) {
    const UncertainLine2 raw = uncertain_line(s, form);
    // l_c = K^-T l, K^-1 = [[scale I, centre], [0, 1]]
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();
    inverse.topLeftCorner<2, 2>() *= image.scale_px;
    inverse.topRightCorner<2, 1>() = image.centre_px;
    const UncertainLine2 expected = spherically_normalised(
        UncertainLine2{inverse.transpose() * raw.mean, inverse.transpose() * raw.cov * inverse});
    const UncertainLine2 line = uncertain_line(s, form, image);
    EXPECT_NEAR((line.mean - expected.mean).norm(), 0.0, 1e-11);
    EXPECT_LT((line.cov - expected.cov).norm(), 1e-8 * expected.cov.norm());
  }
}

TEST(UncertainLine, RejectsSegmentsWithoutLengthOrPrecision) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  UncertainSegment2 point = horizontal();
  point.segment.end = point.segment.start;
  UncertainSegment2 infinite = horizontal();
  infinite.segment.end.x() = std::numeric_limits<double>::infinity();
  UncertainSegment2 no_q = horizontal();
  no_q.sigma_q_px = 0.0;
  UncertainSegment2 no_phi = horizontal();
  no_phi.sigma_phi_rad = nan;
  for (const UncertainSegment2& s : {point, infinite, no_q, no_phi}) {
    EXPECT_THROW(uncertain_line(s, LineCovariance::kEq1), std::invalid_argument);
  }
}

}  // namespace
}  // namespace ridgeline
