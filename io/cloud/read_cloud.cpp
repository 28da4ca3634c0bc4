// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/read_cloud.h"

#include "io/cloud/block_reader.h"
#include "io/cloud/cloud_origin.h"
#include "io/cloud/cloud_source.h"
#include "io/cloud/common_crs.h"
#include "io/cloud/point_filter.h"
#include "io/error.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <span>

namespace ridgeline::io {

namespace {

using Sources = std::vector<std::unique_ptr<CloudSource>>;

void check_options(const std::vector<std::string>& paths, const ReadOptions& options) {
  check(!paths.empty(), "read_cloud: no file given, must be at least one");
  check(!options.near || options.frame,
        "read_cloud: near is set but frame is not; the mask is in local coordinates");
  check(!options.bounds_in_world || !options.bounds_in_world->isEmpty(),
        "read_cloud: bounds_in_world is empty, must have min <= max");
  check(options.max_resolution_m >= 0.0 && std::isfinite(options.max_resolution_m),
        "read_cloud: max_resolution_m = ", options.max_resolution_m, ", must be 0 or above");
}

Sources open_all(const std::vector<std::string>& paths, const ReadOptions& options) {
  Sources sources;
  for (const std::string& path : paths) {
    sources.push_back(open_cloud(
        path, {.salvage = options.salvage, .max_resolution_m = options.max_resolution_m}));
  }
  return sources;
}

std::uint64_t point_limit(const ReadOptions& options) {
  constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
  return std::min(
      options.max_points == 0 ? kNone : options.max_points,
      options.max_memory_bytes == 0 ? kNone : options.max_memory_bytes / sizeof(CloudPoint));
}

/// Reserves once, so that growth never holds the points twice. Pages of a reserve that stay unused
/// cost no memory, so a bound is good enough for small clouds; large ones are counted first.
void reserve(const Sources& sources,
             const CommonCrs& common,
             const PointFilter& filter,
             const ReadOptions& options,
             PointCloud& cloud) {
  constexpr std::uint64_t kBoundIsGoodEnough = 1U << 25U;  // points; 1 GiB of address space
  const std::uint64_t limit = point_limit(options);
  std::uint64_t expected = 0;
  for (const auto& source : sources) expected += source->info().n_points;
  if (expected > std::min(limit, kBoundIsGoodEnough)) {
    expected = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      expected += count_kept(*sources[i], {common.unit_m[i], cloud.frame.origin_m}, filter);
    }
  }
  const std::string& path = sources.front()->info().path;
  if (expected > limit) {
    throw IoError(path,
                  fmt::format("{} points to keep of {} file(s) take {} bytes; allowed are {} "
                              "points (max_points, max_memory)",
                              expected, sources.size(), expected * sizeof(CloudPoint), limit));
  }
  try {
    cloud.points.reserve(expected);
  } catch (const std::bad_alloc&) {
    throw IoError(path, fmt::format("{} points to keep take {} bytes; that memory is not to be had",
                                    expected, expected * sizeof(CloudPoint)));
  }
}

void add_drops(const DropCounts& counts, PointCloud& cloud) {
  cloud.n_dropped_non_finite += counts.non_finite;
  cloud.n_dropped_withheld += counts.withheld;
  cloud.n_dropped_class += counts.classification;
  cloud.n_dropped_return += counts.not_last_return;
  cloud.n_dropped_bounds += counts.outside;
}

/// Coordinates that went through float32 have lost digits that nothing brings back.
std::optional<std::string> float_damage(const CloudFileInfo& info,
                                        const Eigen::AlignedBox3d& extent_in_world,
                                        const ReadOptions& options) {
  constexpr double kFloatEpsilon = 0x1p-23;
  if (!info.has_float_coordinates || extent_in_world.isEmpty()) return std::nullopt;
  const double largest_m =
      extent_in_world.min().cwiseAbs().cwiseMax(extent_in_world.max().cwiseAbs()).maxCoeff();
  const double step_m = largest_m * kFloatEpsilon;
  if (step_m <= options.max_coordinate_step_m) return std::nullopt;
  return fmt::format(
      "coordinates up to {:.0f} m are stored as float32, in steps of up to {:.3g} m; steps above "
      "{} m spoil plane fits, store doubles or subtract an offset first",
      largest_m, step_m, options.max_coordinate_step_m);
}

std::optional<std::string> wrong_bounds(const CloudFileInfo& info,
                                        const Eigen::Vector3d& unit_m,
                                        const Eigen::AlignedBox3d& extent_in_world) {
  constexpr double kTolerance = 0.01;  // file units: writers round bounds to the scale
  if (!info.stated_bounds || extent_in_world.isEmpty()) return std::nullopt;
  const Eigen::Vector3d low = extent_in_world.min().cwiseQuotient(unit_m);
  const Eigen::Vector3d high = extent_in_world.max().cwiseQuotient(unit_m);
  const bool agree = ((low - info.stated_bounds->min()).cwiseAbs().maxCoeff() <= kTolerance) &&
                     ((high - info.stated_bounds->max()).cwiseAbs().maxCoeff() <= kTolerance);
  if (agree) return std::nullopt;
  return fmt::format(
      "header bounds are wrong: x {} to {}, y {} to {}, z {} to {}; the points span x {} to {}, y "
      "{} to {}, z {} to {}",
      info.stated_bounds->min().x(), info.stated_bounds->max().x(), info.stated_bounds->min().y(),
      info.stated_bounds->max().y(), info.stated_bounds->min().z(), info.stated_bounds->max().z(),
      low.x(), high.x(), low.y(), high.y(), low.z(), high.z());
}

void append_source(const CloudSource& source,
                   const Eigen::Vector3d& unit_m,
                   const PointFilter& filter,
                   const ReadOptions& options,
                   PointCloud& cloud) {
  const CloudFileInfo& info = source.info();
  const auto warn = [&](const std::string& text) {
    cloud.warnings.push_back(info.path + ": " + text);
  };
  for (const std::string& warning : info.warnings) warn(warning);
  const ReadSummary summary =
      append_points(source, {unit_m, cloud.frame.origin_m}, filter, cloud.points);
  cloud.n_read += summary.n_read;
  add_drops(summary.drops, cloud);
  if (info.n_points == 0) warn("has no points");
  if (summary.has_whole_extent) {
    if (const auto text = wrong_bounds(info, unit_m, summary.extent_in_world)) warn(*text);
  }
  if (const auto text = float_damage(info, summary.extent_in_world, options)) {
    if (options.strict) throw IoError(info.path, *text);
    warn(*text);
  }
}

}  // namespace

LocalFrame suggest_frame(const std::vector<std::string>& paths_or_patterns,
                         const ReadOptions& options) {
  const std::vector<std::string> paths = expand_patterns(paths_or_patterns);
  check(!paths.empty(), "suggest_frame: no file given, must be at least one");
  const Sources sources = open_all(paths, options);
  return cloud_origin(sources, find_common_crs(sources, options.assume_crs).unit_m);
}

PointCloud read_cloud(const std::vector<std::string>& paths_or_patterns,
                      const ReadOptions& options) {
  const std::vector<std::string> paths = expand_patterns(paths_or_patterns);
  check_options(paths, options);
  Sources sources = open_all(paths, options);
  CommonCrs common = find_common_crs(sources, options.assume_crs);

  PointCloud cloud;
  cloud.crs = std::move(common.crs);
  cloud.warnings = std::move(common.warnings);
  cloud.horizontal_unit_m = common.unit_m.front().x();
  cloud.vertical_unit_m = common.unit_m.front().z();
  cloud.frame = options.frame ? *options.frame : cloud_origin(sources, common.unit_m);
  const PointFilter filter(options, cloud.frame);
  reserve(sources, common, filter, options, cloud);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    append_source(*sources[i], common.unit_m[i], filter, options, cloud);
    sources[i].reset();  // unmaps the file
  }
  return cloud;
}

}  // namespace ridgeline::io
