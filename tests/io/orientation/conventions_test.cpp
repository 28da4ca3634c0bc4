// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/conventions.h"

#include "tests/support/random.h"
#include "tests/support/temp_folder.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>

#include <numbers>

namespace ridgeline::io {
namespace {

using enum AngleUnit;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kRotationRounding = 1e-14;

TEST(PossibleUnits, AreThoseOfAtMostAFullTurn) {
  EXPECT_THAT(possible_units({{1.0, 2.0, 6.28}}), ElementsAre(kDegree, kGon, kRadian));
  EXPECT_THAT(possible_units({{1.0, 2.0, 6.29}}), ElementsAre(kDegree, kGon));
  EXPECT_THAT(possible_units({{1.0, -399.0, 0.0}, {0.0, 0.0, 1.0}}), ElementsAre(kGon));
  EXPECT_THAT(possible_units({{401.0, 0.0, 0.0}}), ElementsAre());
}

TEST(RotationOf, TurnsByOmegaPhiKappaInTheStatedOrder) {
  const Angles right_angles{0.0, 90.0, 90.0};
  const Eigen::Matrix3d R = rotation_of(right_angles, kDegree, RotationOrder::kOmegaPhiKappa);
  // kappa takes x to y; phi, about y, leaves it there
  EXPECT_LT((R * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), kRotationRounding);
  const Angles three{30.0, 40.0, 50.0};
  const auto about = [](double deg, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(deg * std::numbers::pi / 180.0, axis).toRotationMatrix();
  };
  const Eigen::Matrix3d pok = about(40.0, Eigen::Vector3d::UnitY()) *
                              about(30.0, Eigen::Vector3d::UnitX()) *
                              about(50.0, Eigen::Vector3d::UnitZ());
  EXPECT_LT((rotation_of(three, kDegree, RotationOrder::kPhiOmegaKappa) - pok).norm(),
            kRotationRounding);
}

TEST(RotationOf, GivesTheSameInEveryUnit) {
  test::Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d deg = random.vector(-180.0, 180.0);
    const auto angles = [&](double factor) {
      return Angles{factor * deg.x(), factor * deg.y(), factor * deg.z()};
    };
    const auto order = i % 2 == 0 ? RotationOrder::kOmegaPhiKappa : RotationOrder::kPhiOmegaKappa;
    const Eigen::Matrix3d R = rotation_of(angles(1.0), kDegree, order);
    EXPECT_LT((rotation_of(angles(10.0 / 9.0), kGon, order) - R).norm(), kRotationRounding);
    EXPECT_LT((rotation_of(angles(std::numbers::pi / 180.0), kRadian, order) - R).norm(),
              kRotationRounding);
  }
}

/// Two strips of vertical images that were flown in opposite directions along `azimuth_deg`.
Orientation strips(double azimuth_deg) {
  Orientation orientation;
  for (int i = 0; i < 8; ++i) {
    const double along_m = 300.0 * (i % 4);
    const double across_m = i < 4 ? 0.0 : 700.0;
    const double azimuth = azimuth_deg * std::numbers::pi / 180.0;
    OrientedImage image;
    image.name = std::to_string(i);
    image.exterior.position_m = {along_m * std::cos(azimuth) - across_m * std::sin(azimuth),
                                 along_m * std::sin(azimuth) + across_m * std::cos(azimuth),
                                 1000.0};
    const double kappa = azimuth + (i < 4 ? 0.0 : std::numbers::pi);
    image.exterior.world_from_camera_axes = world_from_camera_axes(0.0, 0.0, kappa);
    orientation.images.push_back(image);
  }
  return orientation;
}

constexpr double kAngleRounding_deg = 1e-9;

TEST(MeanAngleToStrips, IsThatOfTheSidesOfTheImages) {
  Orientation block = strips(33.0);
  EXPECT_NEAR(mean_angle_to_strips_deg(block).value(), 0.0, kAngleRounding_deg);
  for (OrientedImage& image : block.images) {
    image.exterior.world_from_camera_axes *=
        world_from_camera_axes(0.0, 0.0, 100.0 / 180.0 * std::numbers::pi);
  }
  EXPECT_NEAR(mean_angle_to_strips_deg(block).value(), 10.0, kAngleRounding_deg);
  for (OrientedImage& image : block.images) {
    image.exterior.world_from_camera_axes *= world_from_camera_axes(1.0, 0.0, 0.0);  // oblique
  }
  EXPECT_FALSE(mean_angle_to_strips_deg(block).has_value());
}

/// The block as read from angles in degrees that are those of the images times `factor`.
RotationReading reading_of(const Orientation& block, const std::string& unit, double factor) {
  RotationReading reading{"angles in " + unit, "angles: " + unit, {}};
  for (const OrientedImage& image : block.images) {
    const Eigen::Matrix3d& R = image.exterior.world_from_camera_axes;
    reading.world_from_camera_axes.push_back(
        world_from_camera_axes(0.0, 0.0, factor * std::atan2(R(1, 0), R(0, 0))));
  }
  return reading;
}

TEST(DecideRotations, GoesByTheStripsWhereThereAreNoPoints) {
  Orientation block = strips(33.0);
  const std::vector<RotationReading> readings{reading_of(block, "gon", 0.9),
                                              reading_of(block, "deg", 1.0)};
  decide_rotations("a.csv", readings, {}, block);
  EXPECT_NEAR(mean_angle_to_strips_deg(block).value(), 0.0, kAngleRounding_deg);
  EXPECT_THAT(block.decisions,
              ElementsAre(HasSubstr("angles in deg (with angles in gon images are aligned")));
}

TEST(DecideRotations, AsksWhereTheStripsDoNotTell) {
  Orientation block = strips(0.0);
  block.images.resize(4);  // kappa is zero in every unit but for a tilt
  RotationReading tilted = reading_of(block, "gon", 0.9);
  for (Eigen::Matrix3d& R : tilted.world_from_camera_axes)
    R *= world_from_camera_axes(0.01, 0.0, 0.0);
  const std::vector<RotationReading> readings{reading_of(block, "deg", 1.0), tilted};
  EXPECT_THAT(io_error_of([&] { decide_rotations("a.csv", readings, {}, block); }),
              HasSubstr("give one of: angles: deg | angles: gon"));
}

TEST(DecideRotations, SaysWhatWouldTellWhereThereIsNothing) {
  Orientation block = strips(33.0);
  block.images.resize(2);
  const std::vector<RotationReading> readings{reading_of(block, "deg", 1.0),
                                              reading_of(block, "gon", 0.9)};
  EXPECT_THAT(io_error_of([&] { decide_rotations("a.csv", readings, {}, block); }),
              HasSubstr("(tie points require images and cameras (cameras: FILE)"));
}

TEST(DecideRotations, TakesTheFirstOfThoseThatMeanTheSame) {
  Orientation block = strips(0.0);
  block.images.resize(4);
  const std::vector<RotationReading> readings{reading_of(block, "deg", 1.0),
                                              reading_of(block, "gon", 0.9)};
  decide_rotations("a.csv", readings, {}, block);
  EXPECT_THAT(block.decisions, ElementsAre());
}

TEST(MedianRayDistance, NeedsPointsThatTwoCamerasSee) {
  Orientation block = strips(20.0);
  std::vector<PointObservation> points(20);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {i / 2, i % 2, {100.0, 100.0}};
  EXPECT_FALSE(median_ray_distance_px(block, points).has_value());  // no cameras
  block.cameras.push_back({"c", {{1000.0, 1000.0}, {500.0, 500.0}, {}, {}}});
  for (OrientedImage& image : block.images) image.camera = 0;
  EXPECT_TRUE(median_ray_distance_px(block, points).has_value());
  points.resize(18);
  EXPECT_FALSE(median_ray_distance_px(block, points).has_value());
}

}  // namespace
}  // namespace ridgeline::io
