// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/aerial_cameras.h"

#include "tests/other_scenes/random_stream.h"

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

Eigen::Matrix3d random_attitude(RandomStream& random) {
  const double degree = M_PI / 180.0;
  const Eigen::Matrix3d axes = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  return (Eigen::AngleAxisd(random.normal(degree), Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(random.normal(degree), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(random.normal(degree), Eigen::Vector3d::UnitZ()))
             .toRotationMatrix() *
         axes;
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

std::array<AerialCamera, 2> cameras_for(const Scene& scene, std::uint64_t seed) {
  RandomStream random(seed + 1000U);
  const double heading = random.uniform(-2.0, 2.0) * M_PI / 180.0;
  const Eigen::Vector3d base(std::cos(heading), std::sin(heading), random.normal(0.01));
  const Eigen::Vector3d middle(random.normal(40.0), random.normal(40.0), kHeight_m);
  std::array<AerialCamera, 2> cameras;
  for (int i = 0; i < 2; ++i) {
    cameras[i].centre = middle + (i - 0.5) * kBase_m * base;
    cameras[i].camera_from_local_axes = random_attitude(random).transpose();
    crop(cameras[i], scene);
  }
  return cameras;
}

}  // namespace ridgeline::other
