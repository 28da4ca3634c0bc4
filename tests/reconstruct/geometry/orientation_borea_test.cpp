// SPDX-License-Identifier: BSD-3-Clause
// Real omega-phi-kappa orientations with tie points, whose published coordinates are the
// intersections of another tool.
#include "reconstruct/geometry/orientation.h"
#include "tests/support/paths.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace ridgeline {
namespace {

// Published heights are ellipsoidal, the heights of the shots are altitudes.
constexpr double kHeightShiftM = -49.30;
constexpr double kPlanToleranceM = 0.005;  // MAD; 2.7 and 3.6 mm were measured
constexpr double kHeightToleranceM = 0.015;
constexpr double kRadPerDeg = std::numbers::pi / 180.0;

struct Observation {
  std::string shot;
  Eigen::Vector2d x_px;
};

struct Borea {
  InteriorOrientation interior;
  std::map<std::string, ExteriorOrientation> shots;
  std::map<std::string, std::vector<Observation>> observations;  ///< by point
  std::map<std::string, Eigen::Vector3d> points;
};

Borea read_borea(const std::string& folder) {
  Borea data;
  data.interior.focal_length_px = {30975.0, 30975.0};
  data.interior.principal_point_px = {13210.0, 8502.0};
  std::string point;
  std::string name;
  std::string camera;
  std::ifstream shots(folder + "/shots.OPK");
  std::getline(shots, name);  // header
  Eigen::Vector3d x;
  Eigen::Vector3d opk;
  while (shots >> name >> x.x() >> x.y() >> x.z() >> opk.x() >> opk.y() >> opk.z() >> camera) {
    opk *= kRadPerDeg;
    data.shots[name] = {x, world_from_camera_axes(opk.x(), opk.y(), opk.z())};
  }
  std::ifstream observations(folder + "/observations.mes");
  Eigen::Vector2d x_px;
  while (observations >> point >> name >> x_px.x() >> x_px.y()) {
    data.observations[point].push_back({name, x_px});
  }
  std::ifstream points(folder + "/points_world.mes");
  while (points >> point >> x.x() >> x.y() >> x.z()) data.points[point] = x;
  return data;
}

/// The point with the least sum of squared distances to all rays.
Eigen::Vector3d intersection(const Borea& data, const std::vector<Observation>& observations) {
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = data.shots.begin()->second.position_m;
  for (const Observation& observation : observations) {
    const ExteriorOrientation& shot = data.shots.at(observation.shot);
    const ProjectionMatrix P = projection_matrix(data.interior, shot);
    const Eigen::Vector3d ray =
        (P.leftCols<3>().inverse() * observation.x_px.homogeneous()).normalized();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - ray * ray.transpose();
    normal_matrix += across;
    right_side += across * (shot.position_m - origin);
  }
  return origin + normal_matrix.ldlt().solve(right_side);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_absolute_deviation(std::vector<double> values) {
  const double centre = median(values);
  for (double& value : values) value = std::abs(value - centre);
  return median(values);
}

TEST(ProjectionMatrixOfOrientation, MakesRealRaysMeetInThePublishedPoints) {
  const std::string folder = test::shared_data_dir() + "/borea";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const Borea data = read_borea(folder);
  ASSERT_EQ(data.shots.size(), 20U);
  ASSERT_EQ(data.points.size(), 200U);
  std::vector<double> differences[3];
  for (const auto& [name, published] : data.points) {
    const Eigen::Vector3d difference = intersection(data, data.observations.at(name)) -
                                       (published + Eigen::Vector3d(0.0, 0.0, kHeightShiftM));
    for (int axis = 0; axis < 3; ++axis) differences[axis].push_back(difference[axis]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double tolerance_m = axis == 2 ? kHeightToleranceM : kPlanToleranceM;
    EXPECT_LT(median_absolute_deviation(differences[axis]), tolerance_m) << axis;
    EXPECT_LT(std::abs(median(differences[axis])), tolerance_m) << axis;
    RecordProperty("mad_mm_axis_" + std::to_string(axis),
                   std::to_string(1000.0 * median_absolute_deviation(differences[axis])));
  }
}

}  // namespace
}  // namespace ridgeline
