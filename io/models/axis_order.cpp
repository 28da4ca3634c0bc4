// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/axis_order.h"

#include "io/crs/area_of_use.h"
#include "io/crs/proj_objects.h"
#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
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

bool is_in_area_of_use(const Crs& crs, double east, double north) {
  constexpr double kMargin_m = 50e3;  // surveys reach beyond borders
  const std::optional<double> outside_m = distance_from_area_of_use_m(crs, {east, north});
  return outside_m && *outside_m <= kMargin_m;
}

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
  const bool fits_as_is = is_in_area_of_use(model.crs, first, second);
  const bool fits_swapped = is_in_area_of_use(model.crs, second, first);
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
