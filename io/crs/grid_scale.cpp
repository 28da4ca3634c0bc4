// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/grid_scale.h"

#include "io/crs/proj_objects.h"
#include "io/error.h"
#include "reconstruct/geometry/degrees.h"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <proj.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace ridgeline::io {
namespace {

using proj::Object;

struct Ellipsoid {
  double a_m = 6378137.0;
  double e2 = 0.0;
};

std::optional<Ellipsoid> ellipsoid_of(PJ_CONTEXT* context, const PJ* crs) {
  const Object ellipsoid(proj_get_ellipsoid(context, crs));
  double a_m = 0.0;
  double b_m = 0.0;
  if (!ellipsoid ||
      proj_ellipsoid_get_parameters(context, ellipsoid.get(), &a_m, &b_m, nullptr, nullptr) == 0) {
    return std::nullopt;
  }
  return Ellipsoid{a_m, 1.0 - (b_m * b_m) / (a_m * a_m)};
}

/// The operation from east and north of a projected CRS to longitude and latitude in its own datum,
/// degrees.
Object lonlat_from_grid(PJ_CONTEXT* context, const PJ* projected) {
  const Object geodetic(proj_crs_get_geodetic_crs(context, projected));
  if (!geodetic) return nullptr;
  const Object operation(
      proj_create_crs_to_crs_from_pj(context, projected, geodetic.get(), nullptr, nullptr));
  if (!operation) return nullptr;
  return Object(proj_normalize_for_visualization(context, operation.get()));
}

/// Longitude and latitude of a place, degrees; non-finite where the projection is undefined.
Eigen::Vector2d lonlat_deg(PJ* operation, const Eigen::Vector2d& x) {
  const PJ_COORD out = proj_trans(operation, PJ_FWD, proj_coord(x.x(), x.y(), 0.0, 0.0));
  return {out.xy.x, out.xy.y};
}

/// Metres east and north on the ellipsoid for small differences of longitude and latitude.
Eigen::Vector2d ground_m(const Eigen::Vector2d& difference_deg,
                         double lat_deg,
                         const Ellipsoid& ellipsoid) {
  const double s = std::sin(lat_deg * kRadPerDeg);
  const double w2 = 1.0 - ellipsoid.e2 * s * s;
  const double across_meridian_m = ellipsoid.a_m / std::sqrt(w2);
  const double along_meridian_m = across_meridian_m * (1.0 - ellipsoid.e2) / w2;
  const double east_deg = std::remainder(difference_deg.x(), 360.0);
  return {across_meridian_m * std::cos(lat_deg * kRadPerDeg) * east_deg * kRadPerDeg,
          along_meridian_m * difference_deg.y() * kRadPerDeg};
}

bool holds_place(PJ_CONTEXT* context, const PJ* crs, double lon_deg, double lat_deg) {
  double west = 0.0;
  double south = 0.0;
  double east = 0.0;
  double north = 0.0;
  const Object known = proj::identified(context, *crs);
  if (proj_get_area_of_use(context, known.get(), &west, &south, &east, &north, nullptr) == 0 ||
      south > north || south < -90.0) {
    return true;
  }
  const bool in_longitude =
      west <= east ? lon_deg >= west && lon_deg <= east : lon_deg >= west || lon_deg <= east;
  return in_longitude && lat_deg >= south && lat_deg <= north;
}

/// The place for messages: "9.177 E, 48.780 N".
std::string place_text(const GridScale& scale) {
  return fmt::format("{:.3f} {}, {:.3f} {}", std::abs(scale.lon_deg),
                     scale.lon_deg < 0.0 ? 'W' : 'E', std::abs(scale.lat_deg),
                     scale.lat_deg < 0.0 ? 'S' : 'N');
}

}  // namespace

bool GridScale::is_true() const {
  return ((scale.array() - 1.0).abs() <= kMaxScaleError).all() && std::abs(skew) <= kMaxScaleError;
}

std::optional<GridScale> grid_scale(const Crs& crs, const Eigen::Vector2d& position) {
  if (!crs.known()) return std::nullopt;
  constexpr double kStep_m = 100.0;
  const proj::Context context = proj::make_context();
  const proj::Parts parts = proj::split(context.get(), crs);
  const PJ* const grid = parts.horizontal.get();
  if (grid == nullptr || proj_get_type(grid) != PJ_TYPE_PROJECTED_CRS) return std::nullopt;
  const auto ellipsoid = ellipsoid_of(context.get(), grid);
  const Object operation = lonlat_from_grid(context.get(), grid);
  if (!ellipsoid || !operation) return std::nullopt;

  const Eigen::Vector2d place_deg = lonlat_deg(operation.get(), position);
  const double step = kStep_m / proj::axis_unit(context.get(), grid, 0).size_m;
  Eigen::Matrix2d ground_from_grid;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d offset = step * Eigen::Vector2d::Unit(axis);
    const Eigen::Vector2d difference_deg = lonlat_deg(operation.get(), position + offset) -
                                           lonlat_deg(operation.get(), position - offset);
    ground_from_grid.col(axis) =
        ground_m(difference_deg, place_deg.y(), *ellipsoid) / (2.0 * kStep_m);
  }
  const Eigen::Vector2d lengths = ground_from_grid.colwise().norm();
  if (!ground_from_grid.allFinite() || lengths.minCoeff() <= 0.0) return std::nullopt;
  return GridScale{
      .scale = lengths.cwiseInverse(),
      .skew = ground_from_grid.col(0).dot(ground_from_grid.col(1)) / lengths.prod(),
      .lon_deg = place_deg.x(),
      .lat_deg = place_deg.y(),
      .in_area_of_use = holds_place(context.get(), grid, place_deg.x(), place_deg.y())};
}

std::string scale_text(const GridScale& scale) {
  return fmt::format("{:.4g} in x and {:.4g} in y at {}", scale.scale.x(), scale.scale.y(),
                     place_text(scale));
}

std::string utm_zone_text(const Crs& crs, const GridScale& scale) {
  struct Series {
    std::string_view datum;
    int first_code;  ///< EPSG code of a zone minus its number
    int first_zone, last_zone;
  };
  constexpr std::array kSeries{Series{"ETRS89", 25800, 28, 38}, Series{"NAD83", 26900, 1, 23}};
  constexpr int kWgs84North = 32600, kWgs84South = 32700;
  const int zone =
      std::clamp(static_cast<int>(std::floor((scale.lon_deg + 180.0) / 6.0)) + 1, 1, 60);
  const bool is_north = scale.lat_deg >= 0.0;
  const std::string name = describe(crs).name;
  for (const Series& s : kSeries) {
    if (!is_north || !name.starts_with(s.datum)) continue;
    if (zone < s.first_zone || zone > s.last_zone) continue;
    return fmt::format("{} / UTM zone {}N (EPSG:{})", s.datum, zone, s.first_code + zone);
  }
  return fmt::format("WGS 84 / UTM zone {}{} (EPSG:{})", zone, is_north ? 'N' : 'S',
                     (is_north ? kWgs84North : kWgs84South) + zone);
}

std::string require_true_scale(const std::string& path,
                               const Crs& crs,
                               const Eigen::Vector2d& position,
                               const std::string& remedy) {
  const std::optional<GridScale> scale = grid_scale(crs, position);
  if (!scale || scale->is_true()) return "";
  const std::string name = describe(crs).name;
  if (!scale->in_area_of_use) {
    return fmt::format(
        "{}: lies at {} according to \"{}\", outside its area of use; is this the right reference "
        "system?",
        path, place_text(*scale), name);
  }
  throw IoError(
      path,
      fmt::format("the map scale of \"{}\" is {}, while heights are true, so all figures would be "
                  "wrong; it must be within {:g} % of 1: project the data, for instance to {}{}",
                  name, scale_text(*scale), 100.0 * kMaxScaleError, utm_zone_text(crs, *scale),
                  remedy));
}

}  // namespace ridgeline::io
