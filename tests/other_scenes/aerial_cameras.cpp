// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/aerial_cameras.h"

#include "tests/other_scenes/random_stream.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::other {
namespace {

constexpr double kHeight_m = 800.0;
constexpr double kBase_m = 208.0;

/// The window of the image that the patch fills at the height of the ground.
void crop(AerialCamera& camera, const Scene& scene) {
  Eigen::Array2d low = Eigen::Array2d::Constant(1e9);
  Eigen::Array2d high = -low;
  for (const double x : {-scene.half_extent_m, scene.half_extent_m}) {
    for (const double y : {-scene.half_extent_m, scene.half_extent_m}) {
      const Eigen::Array2d corner = camera.pixel(scene.on_ground({x, y})).array();
      low = low.min(corner);
      high = high.max(corner);
    }
  }
  const Eigen::Array2d first = low.floor();
  camera.principal_point_px -= first.matrix();
  camera.columns = static_cast<int>(std::ceil(high.x() - first.x())) + 1;
  camera.rows = static_cast<int>(std::ceil(high.y() - first.y())) + 1;
}

/// Of a camera whose x axis is at `kappa_rad` from that of the scene, but for its errors.
Eigen::Matrix3d random_attitude(double kappa_rad, RandomStream& random) {
  const double degree = M_PI / 180.0;
  const Eigen::Matrix3d axes = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return (Eigen::AngleAxisd(random.normal(degree), Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(random.normal(degree), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(kappa_rad + random.normal(degree), Eigen::Vector3d::UnitZ()))
             .toRotationMatrix() *
         axes;
}

/// From one projection centre to the next of a strip, unit of the base.
Eigen::Vector3d random_step(double azimuth_rad, RandomStream& random) {
  const double heading = azimuth_rad + random.uniform(-2.0, 2.0) * M_PI / 180.0;
  return {std::cos(heading), std::sin(heading), random.normal(0.01)};
}

struct Strip {
  std::string name;
  int n_views = 0;
  double azimuth_rad = 0.0;
  Eigen::Vector3d middle, step;
};

void fly(const Strip& strip,
         const Scene& scene,
         RandomStream& random,
         std::vector<AerialCamera>& cameras) {
  for (int i = 0; i < strip.n_views; ++i) {
    AerialCamera camera;
    camera.id = strip.name + std::to_string(i + 1);
    camera.centre = strip.middle + (i - 0.5 * (strip.n_views - 1)) * kBase_m * strip.step;
    camera.camera_from_local_axes = random_attitude(strip.azimuth_rad, random).transpose();
    crop(camera, scene);
    cameras.push_back(std::move(camera));
  }
}

}  // namespace

Eigen::Vector2d AerialCamera::pixel(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d in_camera = camera_from_local_axes * (x - centre);
  return focal_length_px * in_camera.head<2>() / in_camera.z() + principal_point_px;
}

Ray AerialCamera::ray(const Eigen::Vector2d& x_px) const {
  const Eigen::Vector2d x = (x_px - principal_point_px) / focal_length_px;
  return {centre, camera_from_local_axes.transpose() * Eigen::Vector3d(x.x(), x.y(), 1.0)};
}

bool AerialCamera::shows(const Eigen::Vector2d& x_px) const {
  return x_px.x() >= -0.5 && x_px.y() >= -0.5 && x_px.x() <= columns - 0.5 &&
         x_px.y() <= rows - 0.5;
}

Eigen::Matrix<double, 3, 4> AerialCamera::image_from_world(const Eigen::Vector3d& origin_m) const {
  Eigen::Matrix3d calibration = Eigen::Matrix3d::Identity();
  calibration(0, 0) = calibration(1, 1) = focal_length_px;
  calibration.block<2, 1>(0, 2) = principal_point_px;
  Eigen::Matrix<double, 3, 4> camera_from_world;
  camera_from_world << camera_from_local_axes, -camera_from_local_axes * (centre + origin_m);
  return calibration * camera_from_world;
}

std::vector<AerialCamera> cameras_for(const Scene& scene,
                                      std::uint64_t seed,
                                      const FlightPlan& plan) {
  constexpr double kRightAngle_rad = 0.5 * M_PI;
  RandomStream random(seed + 1000U);
  const Eigen::Vector3d step = random_step(0.0, random);
  const Eigen::Vector3d middle(random.normal(40.0), random.normal(40.0), kHeight_m);
  std::vector<AerialCamera> cameras;
  fly({"strip", plan.strip, 0.0, middle, step}, scene, random, cameras);
  if (plan.cross > 0) {
    // A quarter of a base along its own way: strips of any numbers of views have no centre in
    // common.
    const Eigen::Vector3d across = random_step(kRightAngle_rad, random);
    const Eigen::Vector3d shifted = middle + 0.25 * kBase_m * across;
    fly({"cross", plan.cross, kRightAngle_rad, shifted, across}, scene, random, cameras);
  }
  if (is_pair(plan)) {
    cameras[0].id = "left";
    cameras[1].id = "right";
  }
  const auto base = cameras.begin() + (plan.strip - 1) / 2;
  std::rotate(cameras.begin(), base, base + 2);
  return cameras;
}

}  // namespace ridgeline::other
