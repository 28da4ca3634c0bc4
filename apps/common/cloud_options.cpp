// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/cloud_options.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Core>

namespace ridgeline::apps {
namespace {

LocalFrame frame_of(const std::vector<double>& origin) {
  const Eigen::Vector3d x(origin[0], origin[1], origin[2]);
  check((x.array() == x.array().round()).all(), "--origin = ", origin[0], ",", origin[1], ",",
        origin[2], ", must be whole metres");
  return {x};
}

}  // namespace

CLI::Option* add_cloud_option(CLI::App& app, CloudArguments& a) {
  return app.add_option(
      "--cloud", a.clouds,
      "LAS, LAZ, PCD, PLY or x y z text; files and patterns are merged into one cloud");
}

void add_assume_crs_option(CLI::App& app, CloudArguments& a) {
  app.add_option("--assume-crs", a.assume_crs,
                 "CRS of all inputs, overriding theirs (EPSG:25832+7837, WKT, ...)");
}

void add_scale_to_ground_flag(CLI::App& app, CloudArguments& a) {
  app.add_flag("--scale-to-ground", a.scale_to_ground,
               "divide plan coordinates by the local map scale, as needed for Web Mercator; "
               "default: refuse data that are not true to scale");
}

void add_cloud_filters(CLI::App& app, CloudArguments& a) {
  const char* group = "Cloud";
  app.add_option("--classes", a.classes,
                 "keep only these ASPRS classes, e.g. 2,6; default: all but noise (7, 18)")
      ->delimiter(',')
      ->check(CLI::Range(0, 255))
      ->group(group);
  app.add_flag("--exclude-withheld,!--include-withheld", a.exclude_withheld,
               "leave out withheld points (default)")
      ->group(group);
  app.add_flag("--last-returns", a.last_returns, "keep only the last return of each pulse")
      ->group(group);
  app.add_option("--bounds", a.bounds, "x_min,y_min,x_max,y_max in the cloud's own coordinates")
      ->delimiter(',')
      ->expected(4)
      ->group(group);
  app.add_option("--origin", a.origin,
                 "origin of the local frame: x,y,z, whole metres; default: from the data")
      ->delimiter(',')
      ->expected(3)
      ->group(group);
  app.add_option("--max-points", a.max_points, "largest number of points to keep; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->group(group);
  app.add_option("--max-memory-mib", a.max_memory_mib,
                 "largest memory for the points kept, MiB; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->group(group);
  app.add_option("--cloud-memory-mib", a.cloud_memory_mib,
                 "memory for points, MiB; larger clouds are read and processed part by part")
      ->check(CLI::Range(1, 1048576))
      ->capture_default_str()
      ->group(group);
  app.add_option("--max-resolution", a.max_resolution_m,
                 "quick look: read COPC levels only down to this point distance, m; 0: all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->group(group);
  app.add_flag("--strict", a.strict,
               "refuse data with coordinate steps above 0.025 m (float32, too few digits)")
      ->group(group);
  app.add_flag("--salvage", a.salvage, "read what is left of a truncated file")->group(group);
}

io::ReadOptions read_options(const CloudArguments& a) {
  io::ReadOptions options;
  if (!a.classes.empty()) options.classes.emplace(a.classes.begin(), a.classes.end());
  options.exclude_withheld = a.exclude_withheld;
  options.last_returns = a.last_returns;
  if (!a.bounds.empty()) options.bounds_in_file = io::plan_bounds(a.bounds);
  if (!a.origin.empty()) options.frame = frame_of(a.origin);
  options.assume_crs.definition = a.assume_crs;
  options.max_points = a.max_points;
  options.max_memory_bytes = a.max_memory_mib << 20U;
  options.strict = a.strict;
  options.salvage = a.salvage;
  options.max_resolution_m = a.max_resolution_m;
  return options;
}

}  // namespace ridgeline::apps
