// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/geoid.h"

#include "io/crs/grid_scale.h"
#include "io/crs/proj_objects.h"
#include "io/error.h"
#include "reconstruct/geometry/degrees.h"

#include <fmt/format.h>
#include <proj_experimental.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

namespace ridgeline::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWorldGrid = "egm96_15.gtx";
constexpr double kWorldAccuracy_m = 2.0;
constexpr double kOwnAccuracy_m = 0.5;  // of a grid made for the local height system

/// A grid as a transformation; null if PROJ cannot read it.
proj::Object grid_shift(PJ_CONTEXT* context, const std::string& name) {
  // in quotes, because blanks would end the value
  const std::string steps = fmt::format("+proj=vgridshift +grids=\"{}\" +multiplier=1", name);
  return proj::Object(proj_create(context, steps.c_str()));
}

/// The grid's value; std::nullopt where it has none.
std::optional<double> value_at(PJ* grid, double lon_deg, double lat_deg) {
  const PJ_COORD out =
      proj_trans(grid, PJ_FWD, proj_coord(lon_deg * kRadPerDeg, lat_deg * kRadPerDeg, 0.0, 0.0));
  if (!std::isfinite(out.xyz.z) || std::abs(out.xyz.z) > 1e4) return std::nullopt;
  return out.xyz.z;
}

struct FactoryDeleter {
  void operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const {
    proj_operation_factory_context_destroy(factory);
  }
};

/// The operations from a CRS to geographic coordinates with heights above the ellipsoid, including
/// those whose grids are unavailable.
proj::List operations_to_ellipsoid(PJ_CONTEXT* context, const PJ* crs, const PJ* horizontal) {
  const proj::Object geodetic(proj_crs_get_geodetic_crs(context, horizontal));
  if (!geodetic) return nullptr;
  const proj::Object target(proj_crs_promote_to_3D(context, nullptr, geodetic.get()));
  const std::unique_ptr<PJ_OPERATION_FACTORY_CONTEXT, FactoryDeleter> factory(
      proj_create_operation_factory_context(context, nullptr));
  if (!target || !factory) return nullptr;
  proj_operation_factory_context_set_grid_availability_use(context, factory.get(),
                                                           PROJ_GRID_AVAILABILITY_IGNORED);
  proj_operation_factory_context_set_spatial_criterion(context, factory.get(),
                                                       PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
  return proj::List(proj_create_operations(context, crs, target.get(), factory.get()));
}

/// The grids of an operation: the available and the missing ones.
struct OperationGrids {
  std::vector<std::string> names, missing;
};

OperationGrids grids_of(PJ_CONTEXT* context, const PJ* operation) {
  OperationGrids grids;
  const int n = proj_coordoperation_get_grid_used_count(context, operation);
  for (int i = 0; i < n; ++i) {
    const char* name = nullptr;
    int is_there = 0;
    if (proj_coordoperation_get_grid_used(context, operation, i, &name, nullptr, nullptr, nullptr,
                                          nullptr, nullptr, &is_there) == 0 ||
        name == nullptr) {
      continue;
    }
    (is_there != 0 ? grids.names : grids.missing).emplace_back(name);
  }
  return grids;
}

/// The height above the ellipsoid of a point of height 0; std::nullopt outside the grid.
std::optional<double> height_of_zero(PJ_CONTEXT* context,
                                     const PJ* operation,
                                     const Eigen::Vector2d& position) {
  const proj::Object normalized(proj_normalize_for_visualization(context, operation));
  if (!normalized) return std::nullopt;
  const PJ_COORD out =
      proj_trans(normalized.get(), PJ_FWD, proj_coord(position.x(), position.y(), 0.0, HUGE_VAL));
  return std::isfinite(out.xyz.z) ? std::optional(out.xyz.z) : std::nullopt;
}

/// The geoid height from the vertical part of a CRS. Unavailable grids are added to `missing`.
std::optional<GeoidHeight> by_vertical_part(const Crs& crs,
                                            const Eigen::Vector2d& position,
                                            std::set<std::string>& missing) {
  const proj::Context context = proj::make_context();
  const proj::Parts parts = proj::split(context.get(), crs);
  if (!parts.vertical || !parts.horizontal) return std::nullopt;
  const proj::Object whole = proj::create_crs(context.get(), crs);
  const proj::List operations =
      operations_to_ellipsoid(context.get(), whole.get(), parts.horizontal.get());
  const int n = operations ? proj_list_get_count(operations.get()) : 0;
  for (int i = 0; i < n; ++i) {
    const proj::Object operation(proj_list_get(context.get(), operations.get(), i));
    OperationGrids grids = grids_of(context.get(), operation.get());
    missing.insert(grids.missing.begin(), grids.missing.end());
    if (grids.names.empty() || !grids.missing.empty()) continue;
    if (const auto height_m = height_of_zero(context.get(), operation.get(), position)) {
      return GeoidHeight{*height_m, grids.names.front(), kOwnAccuracy_m};
    }
  }
  return std::nullopt;
}

std::optional<GeoidHeight> by_world_grid(const GridScale& place, std::set<std::string>& missing) {
  const proj::Context context = proj::make_context();
  const proj::Object grid = grid_shift(context.get(), kWorldGrid);
  const auto height_m = grid ? value_at(grid.get(), place.lon_deg, place.lat_deg) : std::nullopt;
  if (!height_m) {
    missing.insert(kWorldGrid);
    return std::nullopt;
  }
  return GeoidHeight{*height_m, kWorldGrid, kWorldAccuracy_m};
}

proj::Object user_grid(PJ_CONTEXT* context, const std::string& path) {
  if (!fs::is_regular_file(path)) throw IoError(path, "is not a file; `geoid` takes a geoid grid");
  proj::Object grid = grid_shift(context, fs::absolute(path).string());
  if (grid) return grid;
  throw IoError(path,
                "is not a grid that PROJ can read; must be a GTX or GeoTIFF file with the height "
                "of the geoid above the ellipsoid in metres");
}

}  // namespace

void require_geoid_grid(const std::string& path) {
  const proj::Context context = proj::make_context();
  (void)user_grid(context.get(), path);
}

GeoidAnswer geoid_at(const Crs& crs, const Eigen::Vector2d& position, const std::string& path) {
  GeoidAnswer answer;
  const std::optional<GridScale> place = grid_scale(crs, position);
  if (!place) return answer;
  std::set<std::string> missing;
  if (!path.empty()) {
    const proj::Context context = proj::make_context();
    const proj::Object grid = user_grid(context.get(), path);
    if (const auto height_m = value_at(grid.get(), place->lon_deg, place->lat_deg)) {
      answer.height = GeoidHeight{*height_m, fs::path(path).filename().string(), kOwnAccuracy_m};
      return answer;
    }
    missing.insert(fs::path(path).filename().string() + " at this place");
  }
  answer.height = by_vertical_part(crs, position, missing);
  if (!answer.height) answer.height = by_world_grid(*place, missing);
  answer.missing.assign(missing.begin(), missing.end());
  return answer;
}

}  // namespace ridgeline::io
