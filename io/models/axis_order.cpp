// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/axis_order.h"

#include "io/crs/proj_objects.h"
#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace ridgeline::io {
namespace {

/// The median of one coordinate over the first vertices of the faces, which a few stray faces do
/// not shift.
double median_of(const BuildingModel& model, int axis) {
  return upper_median(
      transformed(model.faces, [&](const Face& face) { return double{face.rings[0][0][axis]}; }));
}

bool has_north_first(PJ_CONTEXT* context, const PJ* crs) {
  const proj::Object system(proj_crs_get_coordinate_system(context, crs));
  const char* direction = nullptr;
  const bool found =
      system && proj_cs_get_axis_info(context, system.get(), 0, nullptr, nullptr, &direction,
                                      nullptr, nullptr, nullptr, nullptr) != 0;
  return found && std::string_view(direction) == "north";
}

/// Determines whether positions (east, north) lie in the area of use of a CRS.
class AreaOfUse {
 public:
  AreaOfUse(PJ_CONTEXT* context, const PJ* crs) {
    has_area_ = proj_get_area_of_use(context, crs, &west_deg_, &south_deg_, &east_deg_, &north_deg_,
                                     nullptr) != 0 &&
                west_deg_ > -1000.0;
    const proj::Object geographic(proj_create(context, "EPSG:4326"));
    const proj::Object step(
        proj_create_crs_to_crs_from_pj(context, crs, geographic.get(), nullptr, nullptr));
    if (step) lon_lat_from_crs_.reset(proj_normalize_for_visualization(context, step.get()));
  }

  [[nodiscard]] bool is_known() const { return has_area_ && lon_lat_from_crs_ != nullptr; }

  [[nodiscard]] bool holds(double east, double north) const {
    constexpr double kMargin_deg = 0.5;  // surveys reach beyond borders
    const PJ_COORD lon_lat =
        proj_trans(lon_lat_from_crs_.get(), PJ_FWD, proj_coord(east, north, 0.0, 0.0));
    const double lon_deg = lon_lat.xy.x;
    const double lat_deg = lon_lat.xy.y;
    if (!std::isfinite(lon_deg) || !std::isfinite(lat_deg)) return false;
    if (lat_deg < south_deg_ - kMargin_deg || lat_deg > north_deg_ + kMargin_deg) return false;
    const bool crosses_date_line = west_deg_ > east_deg_;
    const bool behind_west = lon_deg >= west_deg_ - kMargin_deg;
    const bool before_east = lon_deg <= east_deg_ + kMargin_deg;
    return crosses_date_line ? behind_west || before_east : behind_west && before_east;
  }

 private:
  bool has_area_ = false;
  double west_deg_ = 0.0, south_deg_ = 0.0, east_deg_ = 0.0, north_deg_ = 0.0;
  proj::Object lon_lat_from_crs_;
};

void swap_plan(BuildingModel& model) {
  for (Face& face : model.faces) {
    for (Ring& ring : face.rings) {
      for (Eigen::Vector3d& vertex : ring) std::swap(vertex.x(), vertex.y());
    }
  }
}

}  // namespace

void settle_axis_order(bool keeps_axis_order, BuildingModel& model) {
  if (!model.crs.known() || model.faces.empty()) return;
  const proj::Context context = proj::make_context();
  const proj::Parts parts = proj::split(context.get(), model.crs);
  if (!parts.horizontal || !has_north_first(context.get(), parts.horizontal.get())) return;
  const double first = median_of(model, 0);
  const double second = median_of(model, 1);
  const AreaOfUse area(context.get(), parts.horizontal.get());
  const bool fits_as_is = area.is_known() && area.holds(first, second);
  const bool fits_swapped = area.is_known() && area.holds(second, first);
  const CrsFacts facts = describe(model.crs);
  if (fits_as_is && !fits_swapped) return;
  if (fits_swapped && !fits_as_is) {
    swap_plan(model);
    model.warnings.push_back(fmt::format(
        "coordinates are read as north, east: only then they lie in the area of use of {}",
        facts.name));
  } else if (facts.is_geographic && keeps_axis_order) {
    swap_plan(model);
    model.warnings.push_back(
        fmt::format("coordinates are read as north, east, the axis order of {}", facts.name));
  } else {
    model.warnings.push_back(
        fmt::format("coordinates are read as east, north, although {} has north first: both orders "
                    "are possible",
                    facts.name));
  }
}

}  // namespace ridgeline::io
