// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/conditions.h"

#include "tests/reconstruct/support/conditioned_scene.h"
#include "tests/reconstruct/support/finite_difference.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>

namespace ridgeline::reconstruct {
namespace {

using test::ConditionedScene;
using test::kDegree;

/// Relative error of central differences (finite_difference.h), with room for the scale of 1e4 of
/// whitened conditions.
constexpr double kDifferences = 1e-6;
constexpr double kRounding = 1e-9;

/// Compares derivatives along the four free directions of a line; only there they have a meaning.
template <typename Condition>
void expect_derivatives(const Condition& condition, const Vector6d& line, const Vector6d& stated) {
  const Eigen::Matrix<double, 6, 4> basis = line_tangent_basis(line);
  const auto along = [&](const Eigen::Vector4d& t) {
    return Eigen::Matrix<double, 1, 1>(
        condition(project_to_pluecker_quadric(Vector6d(line + basis * t))));
  };
  Eigen::Matrix<double, 1, 4> differences;
  for (int i = 0; i < 4; ++i) {
    constexpr double kStep = 1e-6;
    const Eigen::Vector4d step = kStep * Eigen::Vector4d::Unit(i);
    differences(i) = (along(step) - along(-step))(0) / (2.0 * kStep);
  }
  const Eigen::Matrix<double, 1, 4> analytic = stated.transpose() * basis;
  EXPECT_LT((analytic - differences).norm(), kDifferences * (1.0 + differences.norm()));
}

class Conditions : public testing::Test {
 protected:
  ConditionedScene scene;
  /// A segment 2 degrees off the epipolar direction, which is the hard case.
  Segment3 segment =
      test::make_segment(scene.scene, {scene.scene.left_centre(), 2.0 * kDegree, 100.0, 3.0, 4.0});
  ObservedTrack seen = scene.observe(test::exact_pair(scene.scene, segment));
  Vector6d line = scene.line(segment);
  Vector6d other = scene.line(
      {segment.start + Eigen::Vector3d(0, 0, 0.5), segment.start + Eigen::Vector3d(1, 7, 2)});
};

TEST_F(Conditions, ImageDeviationIsZeroOnTheTrueLineOfEitherSign) {
  for (std::size_t j = 0; j < 2; ++j) {
    const ImageCondition image(scene.frames.views[j].image_from_object, seen.observations[j].line);
    for (const OfLine& deviation : image.at(line)) EXPECT_NEAR(deviation.value, 0.0, kRounding);
    for (const OfLine& deviation : image.at(-line)) EXPECT_NEAR(deviation.value, 0.0, kRounding);
  }
}

TEST_F(Conditions, ImageDeviationHasUnitVariance) {
  constexpr int kTrials = 2000;
  test::Random random(301);
  double sum = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto noisy = scene.observe(test::noisy_pair(scene.scene, segment, {}, random));
    const ImageCondition image(scene.frames.views[0].image_from_object, noisy.base().line);
    for (const OfLine& deviation : image.at(line)) sum += deviation.value * deviation.value;
  }
  EXPECT_NEAR(sum / kTrials, 2.0, test::chi_square_mean_band(2.0, kTrials));
}

TEST_F(Conditions, ImageDerivatives) {
  for (const double sign : {1.0, -1.0}) {
    // this line is off the observed one by some sigma
    const Vector6d off = sign * scene.line({segment.start + Eigen::Vector3d(0, 0.1, 0.2),
                                            segment.end + Eigen::Vector3d(0, -0.05, 0.4)});
    for (std::size_t j = 0; j < 2; ++j) {
      const ImageCondition image(scene.frames.views[j].image_from_object,
                                 seen.observations[j].line);
      for (const std::size_t i : {0U, 1U}) {
        expect_derivatives([&](const Vector6d& l) { return image.at(l)[i].value; }, off,
                           image.at(off)[i].by_line);
      }
    }
  }
}

TEST_F(Conditions, MeetingIsTheDistanceOfTheLines) {
  const Segment3 above{segment.start + Eigen::Vector3d(-1, -3, 0.7),
                       segment.start + Eigen::Vector3d(1, 3, 0.7)};
  const Eigen::Vector3d normal =
      (segment.end - segment.start).cross(above.end - above.start).normalized();
  const double expected_m = std::abs(normal.dot(above.start - segment.start));
  EXPECT_NEAR(scene.frames.object.scale_m * std::abs(meeting(line, scene.line(above)).value),
              expected_m, kRounding);
}

TEST_F(Conditions, MeetingDerivatives) {
  const OfLinePair at = meeting(line, other);
  expect_derivatives([&](const Vector6d& l) { return meeting(l, other).value; }, line, at.by_first);
  expect_derivatives([&](const Vector6d& l) { return meeting(line, l).value; }, other,
                     at.by_second);
  // nearly parallel lines: 11 degrees is the least that a pair encloses
  const Vector6d near =
      scene.line({segment.start, segment.end + 0.2 * (segment.end - segment.start).norm() *
                                                   Eigen::Vector3d::UnitZ()});
  expect_derivatives([&](const Vector6d& l) { return meeting(l, near).value; }, line,
                     meeting(line, near).by_first);
}

TEST_F(Conditions, RiseIsTheSineOfTheSlope) {
  const Eigen::Vector3d d = segment.end - segment.start;
  EXPECT_NEAR(rise(line).value, d.z() / d.norm(), kRounding);
  expect_derivatives([](const Vector6d& l) { return rise(l).value; }, line, rise(line).by_line);
}

TEST_F(Conditions, HeightIsThatOfTheSegmentsEnd) {
  const ConditionedView& left = scene.frames.views[0];
  const Eigen::Vector4d plane = end_plane(left, seen.base().segment, seen.base().segment.end);
  EXPECT_NEAR(height_in_plane(line, plane).value, scene.conditioned(segment.end).z(), kRounding);
  expect_derivatives([&](const Vector6d& l) { return height_in_plane(l, plane).value; }, line,
                     height_in_plane(line, plane).by_line);
}

TEST_F(Conditions, EndParallaxIsZeroWhereBothEndsShowThePoint) {
  const ConditionedView& right = scene.frames.views[1];
  const Eigen::Vector4d plane =
      end_plane(scene.frames.views[0], seen.base().segment, seen.base().segment.start);
  const auto parallax = [&](const Vector6d& l) {
    return end_parallax(l, plane, right, seen.other().segment, seen.other().segment.start);
  };
  EXPECT_NEAR(parallax(line).value, 0.0, kRounding);
  const Vector6d off = scene.line({segment.start + Eigen::Vector3d(0, 0, 1), segment.end});
  expect_derivatives([&](const Vector6d& l) { return parallax(l).value; }, off,
                     parallax(off).by_line);
  // a metre of height is a parallax of about 0.26 x 1 m / 8 cm along the epipolar direction
  EXPECT_NEAR(std::abs(parallax(off).value) * right.image.scale_px, 0.26 / 0.08, 0.2);
}

}  // namespace
}  // namespace ridgeline::reconstruct
