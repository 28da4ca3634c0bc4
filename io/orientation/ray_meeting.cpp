// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/conventions.h"

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <map>
#include <span>

namespace ridgeline::io {
namespace {

/// The ray of an observation and its camera, in coordinates relative to the centre of the block.
struct ObservedRay {
  Eigen::Vector3d centre, direction;
  Eigen::Vector2d ideal_px;
  ProjectionMatrix image_from_local;
};

std::optional<ObservedRay> ray_of(const Orientation& orientation,
                                  const PointObservation& observation,
                                  const Eigen::Vector3d& origin_m) {
  const OrientedImage& image = orientation.images[observation.image];
  if (!image.camera) return std::nullopt;
  const InteriorOrientation& interior = orientation.cameras[*image.camera].interior;
  const std::optional<Eigen::Vector2d> ideal = undistorted_px(interior, observation.x_px);
  if (!ideal) return std::nullopt;
  const Eigen::Vector2d v =
      (*ideal - interior.principal_point_px).cwiseQuotient(interior.focal_length_px);
  ExteriorOrientation local = image.exterior;
  local.position_m -= origin_m;
  const Eigen::Vector3d direction =
      local.world_from_camera_axes * Eigen::Vector3d(v.x(), -v.y(), -1.0);
  return ObservedRay{local.position_m, direction.normalized(), *ideal,
                     projection_matrix(interior, local)};
}

Eigen::Vector3d meeting_of(std::span<const ObservedRay> rays) {
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  for (const ObservedRay& ray : rays) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
    normal_matrix += across;
    right_side += across * ray.centre;
  }
  return normal_matrix.ldlt().solve(right_side);
}

/// For a point behind the camera the distance is infinite.
double distance_px(const ObservedRay& ray, const Eigen::Vector3d& x_in_local) {
  const Eigen::Vector3d seen = ray.image_from_local * x_in_local.homogeneous();
  if (!(seen.z() > 0.0)) return std::numeric_limits<double>::infinity();
  return (seen.hnormalized() - ray.ideal_px).norm();
}

Eigen::Vector3d middle_of(const Orientation& orientation) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const OrientedImage& image : orientation.images) sum += image.exterior.position_m;
  return sum / static_cast<double>(orientation.images.size());
}

}  // namespace

std::optional<double> median_ray_distance_px(const Orientation& orientation,
                                             const std::vector<PointObservation>& observations) {
  const Eigen::Vector3d origin_m = middle_of(orientation);
  std::map<std::size_t, std::vector<ObservedRay>> rays_of_points;
  for (const PointObservation& observation : observations) {
    if (std::optional<ObservedRay> ray = ray_of(orientation, observation, origin_m)) {
      rays_of_points[observation.point].push_back(*ray);
    }
  }
  std::erase_if(rays_of_points, [](const auto& point) { return point.second.size() < 2; });
  if (rays_of_points.size() < kMinMeetings) return std::nullopt;
  std::vector<double> distances_px;
  for (const auto& [point, rays] : rays_of_points) {
    const Eigen::Vector3d x_in_local = meeting_of(rays);
    for (const ObservedRay& ray : rays) distances_px.push_back(distance_px(ray, x_in_local));
  }
  const auto middle = distances_px.begin() + static_cast<std::ptrdiff_t>(distances_px.size() / 2);
  std::nth_element(distances_px.begin(), middle, distances_px.end());
  return *middle;
}

}  // namespace ridgeline::io
