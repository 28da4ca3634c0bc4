// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/area_of_use.h"

#include "io/crs/proj_objects.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ridgeline::io {
namespace {

/// Bounds in degrees; `west_deg` may be larger than `east_deg`.
struct AreaOfUse {
  double west_deg = 0.0, south_deg = 0.0, east_deg = 0.0, north_deg = 0.0;
};

struct PlaceOnEarth {
  double lat_deg = 0.0, lon_deg = 0.0;
};

/// The area that the system states, or that of the registered system that it is equivalent to.
std::optional<AreaOfUse> area_of(PJ_CONTEXT* context, const PJ& crs) {
  constexpr double kUnset_deg = -1000.0;
  const auto stated = [&](const PJ* system) -> std::optional<AreaOfUse> {
    AreaOfUse area;
    const int found = proj_get_area_of_use(context, system, &area.west_deg, &area.south_deg,
                                           &area.east_deg, &area.north_deg, nullptr);
    if (found == 0 || area.west_deg <= kUnset_deg) return std::nullopt;
    return area;
  };
  if (const auto area = stated(&crs)) return area;
  const proj::Object known = proj::identified(context, crs);
  const char* const code = proj_get_id_code(known.get(), 0);
  if (code == nullptr) return std::nullopt;
  const proj::Object registered(proj_create_from_database(
      context, proj_get_id_auth_name(known.get(), 0), code, PJ_CATEGORY_CRS, 0, nullptr));
  return registered ? stated(registered.get()) : std::nullopt;
}

/// std::nullopt if the position is nowhere on Earth.
std::optional<PlaceOnEarth> place_of(PJ_CONTEXT* context, const PJ& crs, const Eigen::Vector2d& x) {
  const proj::Object geodetic(proj_crs_get_geodetic_crs(context, &crs));
  const proj::Object steps(
      proj_create_crs_to_crs_from_pj(context, &crs, geodetic.get(), nullptr, nullptr));
  if (!steps) return std::nullopt;
  const proj::Object east_first(proj_normalize_for_visualization(context, steps.get()));
  const PJ_COORD place =
      proj_trans(east_first.get(), PJ_FWD, proj_coord(x.x(), x.y(), 0.0, HUGE_VAL));
  const bool is_on_earth = std::abs(place.lp.phi) <= 90.0 && std::abs(place.lp.lam) <= 360.0;
  if (!is_on_earth) return std::nullopt;
  return PlaceOnEarth{place.lp.phi, place.lp.lam};
}

double haversine(double angle_rad) { return std::pow(std::sin(0.5 * angle_rad), 2); }

double distance_m(const PlaceOnEarth& a, const PlaceOnEarth& b) {
  constexpr double kEarthRadius_m = 6.371e6;
  const double h = haversine(kRadPerDeg * (a.lat_deg - b.lat_deg)) +
                   std::cos(kRadPerDeg * a.lat_deg) * std::cos(kRadPerDeg * b.lat_deg) *
                       haversine(kRadPerDeg * (a.lon_deg - b.lon_deg));
  return 2.0 * kEarthRadius_m * std::asin(std::sqrt(std::min(h, 1.0)));
}

/// The distance to the nearest place of the area; 0 inside.
double distance_m(const PlaceOnEarth& place, const AreaOfUse& area) {
  const double lat_deg = std::clamp(place.lat_deg, area.south_deg, area.north_deg);
  const auto east_of_west_deg = [&](double lon_deg) {
    return std::remainder(lon_deg - area.west_deg - 180.0, 360.0) + 180.0;  // in [0, 360]
  };
  if (east_of_west_deg(place.lon_deg) <= east_of_west_deg(area.east_deg)) {
    return distance_m(place, PlaceOnEarth{lat_deg, place.lon_deg});
  }
  return std::min(distance_m(place, PlaceOnEarth{lat_deg, area.west_deg}),
                  distance_m(place, PlaceOnEarth{lat_deg, area.east_deg}));
}

}  // namespace

std::optional<double> distance_from_area_of_use_m(const Crs& crs, const Eigen::Vector2d& x_in_crs) {
  const proj::Context context = proj::make_context();
  const proj::Parts parts = proj::split(context.get(), crs);
  if (!parts.horizontal) return std::nullopt;
  const std::optional<AreaOfUse> area = area_of(context.get(), *parts.horizontal);
  if (!area) return std::nullopt;
  const auto place = place_of(context.get(), *parts.horizontal, x_in_crs);
  return place ? distance_m(*place, *area) : std::numeric_limits<double>::infinity();
}

std::string check_area_of_use(const Crs& crs, const std::vector<Eigen::Vector3d>& x_m) {
  if (!crs.known() || x_m.empty()) return "";
  const CrsFacts facts = describe(crs);
  if (facts.is_geographic) return "";
  const Eigen::Vector2d x = {
      upper_median(transformed(x_m, [](const Eigen::Vector3d& one) { return one.x(); })),
      upper_median(transformed(x_m, [](const Eigen::Vector3d& one) { return one.y(); }))};
  constexpr double kMaxOutside_m = 300e3;
  const double outside_m =
      distance_from_area_of_use_m(crs, x / facts.horizontal_unit_m).value_or(0.0);
  if (outside_m == 0.0) return "";
  const std::string extent =
      std::isfinite(outside_m) ? fmt::format("{:.0f} km", outside_m / 1000.0) : std::string("far");
  std::string text = fmt::format(
      "positions around x = {:.0f}, y = {:.0f} are {} outside the area of use of {}; give the "
      "system of the positions, or the positions with their offset",
      x.x(), x.y(), extent, facts.name);
  if (outside_m > kMaxOutside_m) throw std::invalid_argument(text);
  return text;
}

}  // namespace ridgeline::io
