// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/geocentric.h"

#include "io/crs/proj_objects.h"
#include "reconstruct/geometry/check.h"

#include <Eigen/SVD>
#include <fmt/format.h>
#include <proj_experimental.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ridgeline::io {
namespace {

constexpr double kDegPerRadian = 180.0 / std::numbers::pi;

/// The conversion to geocentric coordinates from longitude and latitude in radians and height.
proj::Object cart_of(PJ_CONTEXT* context, const PJ* crs) {
  const proj::Object ellipsoid(proj_get_ellipsoid(context, crs));
  double semi_major_m = 0.0;
  double inverse_flattening = 0.0;
  proj_ellipsoid_get_parameters(context, ellipsoid.get(), &semi_major_m, nullptr, nullptr,
                                &inverse_flattening);
  const std::string shape = inverse_flattening > 0.0 ? fmt::format("+a={:.17g} +rf={:.17g}",
                                                                   semi_major_m, inverse_flattening)
                                                     : fmt::format("+R={:.17g}", semi_major_m);
  return proj::Object(proj_create(context, ("+proj=cart " + shape).c_str()));
}

GeodeticPlace place_by(PJ* cart, const Eigen::Vector3d& x) {
  const PJ_COORD place = proj_trans(cart, PJ_INV, proj_coord(x.x(), x.y(), x.z(), 0.0));
  return {place.lpz.phi * kDegPerRadian, place.lpz.lam * kDegPerRadian, place.lpz.z};
}

}  // namespace

struct GeocentricMap::Transforms {
  proj::Context context;
  proj::Object cart, map_from_geographic;
  Crs crs;
};

GeocentricMap::GeocentricMap(const Crs& map) : transforms_(std::make_unique<Transforms>()) {
  Transforms& t = *transforms_;
  t.context = proj::make_context();
  PJ_CONTEXT* const context = t.context.get();
  const proj::Parts parts = proj::split(context, map);
  check(parts.horizontal && proj_get_type(parts.horizontal.get()) == PJ_TYPE_PROJECTED_CRS,
        "crs = ", parts.name, ", must be projected");
  const proj::Object target(proj_crs_promote_to_3D(context, nullptr, parts.horizontal.get()));
  const proj::Object plane_source(proj_crs_get_geodetic_crs(context, parts.horizontal.get()));
  const proj::Object source(proj_crs_promote_to_3D(context, nullptr, plane_source.get()));
  proj::Object steps(
      proj_create_crs_to_crs_from_pj(context, source.get(), target.get(), nullptr, nullptr));
  check(steps != nullptr, "crs = ", parts.name, ", must be one that PROJ can project to");
  t.map_from_geographic.reset(proj_normalize_for_visualization(context, steps.get()));
  t.cart = cart_of(context, target.get());
  t.crs.definition = proj_as_wkt(context, target.get(), PJ_WKT2_2019, nullptr);
}

GeocentricMap::~GeocentricMap() = default;

const Crs& GeocentricMap::crs() const { return transforms_->crs; }

GeodeticPlace GeocentricMap::place_of(const Eigen::Vector3d& x_in_geocentric_m) const {
  return place_by(transforms_->cart.get(), x_in_geocentric_m);
}

Eigen::Vector3d GeocentricMap::map_from_geocentric(const Eigen::Vector3d& x_in_geocentric_m) const {
  const GeodeticPlace place = place_of(x_in_geocentric_m);
  const PJ_COORD x = proj_trans(transforms_->map_from_geographic.get(), PJ_FWD,
                                proj_coord(place.lon_deg, place.lat_deg, place.height_m, HUGE_VAL));
  return {x.xyz.x, x.xyz.y, x.xyz.z};
}

Eigen::Vector3d GeocentricMap::geocentric_from_map(const Eigen::Vector3d& x_in_map_m) const {
  const PJ_COORD place =
      proj_trans(transforms_->map_from_geographic.get(), PJ_INV,
                 proj_coord(x_in_map_m.x(), x_in_map_m.y(), x_in_map_m.z(), HUGE_VAL));
  const PJ_COORD x = proj_trans(
      transforms_->cart.get(), PJ_FWD,
      proj_coord(place.xyz.x / kDegPerRadian, place.xyz.y / kDegPerRadian, place.xyz.z, 0.0));
  return {x.xyz.x, x.xyz.y, x.xyz.z};
}

Eigen::Isometry3d GeocentricMap::geocentric_from_enu(const GeodeticPlace& place) const {
  const double lat = place.lat_deg / kDegPerRadian;
  const double lon = place.lon_deg / kDegPerRadian;
  const PJ_COORD origin =
      proj_trans(transforms_->cart.get(), PJ_FWD, proj_coord(lon, lat, place.height_m, 0.0));
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = Eigen::Vector3d(origin.xyz.x, origin.xyz.y, origin.xyz.z);
  frame.linear().col(0) << -std::sin(lon), std::cos(lon), 0.0;
  frame.linear().col(1) << -std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon),
      std::cos(lat);
  frame.linear().col(2) << std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon),
      std::sin(lat);
  return frame;
}

Eigen::Matrix3d GeocentricMap::derivative_at(const Eigen::Vector3d& x_in_geocentric_m) const {
  constexpr double kStep_m = 10.0;  // rounding of 1e-9 m in coordinates of 6e6 m contributes 1e-10
  Eigen::Matrix3d J;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = kStep_m * Eigen::Vector3d::Unit(axis);
    J.col(axis) = (map_from_geocentric(x_in_geocentric_m + step) -
                   map_from_geocentric(x_in_geocentric_m - step)) /
                  (2.0 * kStep_m);
  }
  return J;
}

Eigen::Matrix3d GeocentricMap::map_rotation_at(const Eigen::Vector3d& x_in_geocentric_m) const {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(derivative_at(x_in_geocentric_m),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

double GeocentricMap::plan_scale(const Eigen::Vector3d& x_in_geocentric_m) const {
  const Eigen::Matrix3d enu = geocentric_from_enu(place_of(x_in_geocentric_m)).linear();
  return (derivative_at(x_in_geocentric_m) * enu.leftCols<2>()).colwise().norm().mean();
}

Crs utm_zone_of(const GeodeticPlace& place) {
  constexpr int kNorth = 32600;
  constexpr int kSouth = 32700;
  constexpr double kZone_deg = 6.0;
  const int zone =
      std::clamp(static_cast<int>(std::floor((place.lon_deg + 180.0) / kZone_deg)) + 1, 1, 60);
  return {fmt::format("EPSG:{}", (place.lat_deg < 0.0 ? kSouth : kNorth) + zone)};
}

GeodeticPlace wgs84_place_of(const Eigen::Vector3d& x_in_geocentric_m) {
  const proj::Context context = proj::make_context();
  const proj::Object cart(proj_create(context.get(), "+proj=cart +ellps=WGS84"));
  return place_by(cart.get(), x_in_geocentric_m);
}

}  // namespace ridgeline::io
