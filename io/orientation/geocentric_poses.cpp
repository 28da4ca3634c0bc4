// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/geocentric_poses.h"

#include "io/error.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace ridgeline::io {
namespace {

/// The centre of the images in geocentric coordinates.
Eigen::Vector3d middle_of(const Orientation& orientation, const Eigen::Isometry3d& frame) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const OrientedImage& image : orientation.images) sum += image.exterior.position_m;
  return frame * (sum / static_cast<double>(orientation.images.size()));
}

void require_on_earth(const std::string& path, const Eigen::Vector3d& x_in_geocentric_m) {
  constexpr double kMinRadius_m = 6.3e6;
  constexpr double kMaxRadius_m = 6.5e6;
  const double radius_m = x_in_geocentric_m.norm();
  if (radius_m >= kMinRadius_m && radius_m <= kMaxRadius_m) return;
  throw IoError(
      path,
      fmt::format(
          "has images {:.3g} km from the centre of the Earth; geocentric coordinates are expected",
          radius_m / 1000.0));
}

std::string decision_of(const GeocentricMap& map, const Eigen::Vector3d& middle) {
  const double scale = map.plan_scale(middle);
  constexpr double kExample_m = 100.0;
  return fmt::format(
      "Poses were converted from geocentric coordinates to {}, with heights above the ellipsoid. "
      "Its map scale is {:.5f}, so heights are off by {:.3f} m for each {:.0f} m below the camera.",
      describe(map.crs()).name, scale, std::abs(scale - 1.0) * kExample_m, kExample_m);
}

}  // namespace

void convert_to_map(const std::string& path,
                    const Eigen::Isometry3d& geocentric_from_block,
                    const Crs& map,
                    Orientation& orientation) {
  if (orientation.images.empty()) return;
  const Eigen::Vector3d middle = middle_of(orientation, geocentric_from_block);
  require_on_earth(path, middle);
  try {
    const GeocentricMap target(map.known() ? map : utm_zone_of(wgs84_place_of(middle)));
    for (OrientedImage& image : orientation.images) {
      const Eigen::Vector3d centre = geocentric_from_block * image.exterior.position_m;
      image.exterior.world_from_camera_axes = target.map_rotation_at(centre) *
                                              geocentric_from_block.linear() *
                                              image.exterior.world_from_camera_axes;
      image.exterior.position_m = target.map_from_geocentric(centre);
    }
    orientation.crs = target.crs();
    orientation.decisions.push_back(decision_of(target, middle));
  } catch (const std::invalid_argument& error) {
    throw IoError(path, error.what());
  }
}

TopocentricPoses topocentric_poses(const Orientation& orientation) {
  const GeocentricMap map(orientation.crs);
  std::vector<Eigen::Vector3d> centres;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const OrientedImage& image : orientation.images) {
    centres.push_back(map.geocentric_from_map(image.exterior.position_m));
    sum += centres.back();
  }
  TopocentricPoses poses;
  poses.place = wgs84_place_of(sum / static_cast<double>(centres.size()));
  poses.place.height_m = 0.0;
  poses.geocentric_from_enu = geocentric_from_enu(poses.place);
  const Eigen::Isometry3d enu_from_geocentric = poses.geocentric_from_enu.inverse();
  for (std::size_t i = 0; i < centres.size(); ++i) {
    poses.exterior.push_back(
        {enu_from_geocentric * centres[i],
         enu_from_geocentric.linear() * map.map_rotation_at(centres[i]).transpose() *
             orientation.images[i].exterior.world_from_camera_axes});
  }
  return poses;
}

Eigen::Isometry3d geocentric_from_enu(const GeodeticPlace& place) {
  return GeocentricMap(utm_zone_of(place)).geocentric_from_enu(place);
}

}  // namespace ridgeline::io
