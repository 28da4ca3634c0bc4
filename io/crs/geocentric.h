// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <memory>

namespace ridgeline::io {

/// A place on the ellipsoid.
struct GeodeticPlace {
  double lat_deg = 0.0, lon_deg = 0.0, height_m = 0.0;
};

/// Converts between geocentric coordinates, the ellipsoid and a map whose heights are above that
/// ellipsoid. All three share one datum, so that the conversions are exact and need no grid.
class GeocentricMap {
 public:
  /// Throws std::invalid_argument if PROJ cannot read the definition, and if the system is not
  /// projected.
  explicit GeocentricMap(const Crs& map);
  ~GeocentricMap();
  GeocentricMap(const GeocentricMap&) = delete;
  GeocentricMap& operator=(const GeocentricMap&) = delete;

  /// The map with a third axis for heights above the ellipsoid, as WKT2.
  [[nodiscard]] const Crs& crs() const;

  [[nodiscard]] Eigen::Vector3d map_from_geocentric(const Eigen::Vector3d& x_in_geocentric_m) const;
  [[nodiscard]] Eigen::Vector3d geocentric_from_map(const Eigen::Vector3d& x_in_map_m) const;
  [[nodiscard]] GeodeticPlace place_of(const Eigen::Vector3d& x_in_geocentric_m) const;

  /// The frame with axes east, north and up at a place.
  [[nodiscard]] Eigen::Isometry3d geocentric_from_enu(const GeodeticPlace& place) const;

  /// The rotation nearest to the derivative of map_from_geocentric() at a place. A rotation cannot
  /// represent the map scale, so plan_scale() gives it: the ratio of plan to ground distances.
  [[nodiscard]] Eigen::Matrix3d map_rotation_at(const Eigen::Vector3d& x_in_geocentric_m) const;
  [[nodiscard]] double plan_scale(const Eigen::Vector3d& x_in_geocentric_m) const;

 private:
  [[nodiscard]] Eigen::Matrix3d derivative_at(const Eigen::Vector3d& x_in_geocentric_m) const;
  struct Transforms;
  std::unique_ptr<Transforms> transforms_;
};

/// The code of the WGS 84 UTM zone that contains the place: "EPSG:32632".
Crs utm_zone_of(const GeodeticPlace& place);

/// The place on the WGS 84 ellipsoid with these geocentric coordinates.
GeodeticPlace wgs84_place_of(const Eigen::Vector3d& x_in_geocentric_m);

}  // namespace ridgeline::io
