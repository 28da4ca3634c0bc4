// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/cloud_files.h"

#include "io/cloud/block_reader.h"
#include "io/cloud/cloud_checks.h"
#include "io/cloud/cloud_origin.h"
#include "io/cloud/common_crs.h"
#include "io/error.h"
#include "io/files/mapped_file.h"
#include "io/files/shared_warnings.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace ridgeline::io {

namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

void check_options(const ReadOptions& options) {
  check(!options.bounds_in_file || !options.bounds_in_file->isEmpty(),
        "read_cloud: bounds_in_file is empty, must have min <= max");
  check((options.plan_scale.array() > 0.0).all() && options.plan_scale.allFinite(),
        "read_cloud: plan_scale = ", options.plan_scale.transpose(), ", must be above 0");
  check(options.max_resolution_m >= 0.0 && std::isfinite(options.max_resolution_m),
        "read_cloud: max_resolution_m = ", options.max_resolution_m, ", must be 0 or above");
  check(options.share > 0.0 && options.share <= 1.0, "read_cloud: share = ", options.share,
        ", must be above 0 and at most 1");
}

std::uint64_t point_limit(const ReadOptions& options) {
  return std::min(
      options.max_points == 0 ? kNoLimit : options.max_points,
      options.max_memory_bytes == 0 ? kNoLimit : options.max_memory_bytes / sizeof(CloudPoint));
}

void add_drops(const DropCounts& counts, PointCloud& cloud) {
  cloud.n_dropped_non_finite += counts.non_finite;
  cloud.n_dropped_withheld += counts.withheld;
  cloud.n_dropped_class += counts.classification;
  cloud.n_dropped_return += counts.not_last_return;
  cloud.n_dropped_bounds += counts.outside;
  cloud.n_dropped_share += counts.share;
}

}  // namespace

CloudFiles::CloudFiles(const std::vector<std::string>& paths_or_patterns,
                       const ReadOptions& options)
    : options_(options) {
  const std::vector<std::string> paths = expand_patterns(paths_or_patterns);
  check(!paths.empty(), "read_cloud: no file given, must be at least one");
  check_options(options);
  for (const std::string& path : paths) {
    File& file = files_.emplace_back();
    file.info.path = path;
    file.info = open(file).info();
    close_if_heavy(file);
  }
  begin();
}

CloudFiles::CloudFiles(std::unique_ptr<CloudSource> source, const ReadOptions& options)
    : options_(options) {
  check_options(options);
  check(source->is_light(), "CloudFiles: ", source->info().path, " is heavy, must stay open");
  File& file = files_.emplace_back();
  file.info = source->info();
  file.source = std::move(source);
  begin();
}

void CloudFiles::begin() {
  std::vector<CloudFileInfo> infos;
  for (const File& file : files_) infos.push_back(file.info);
  CommonCrs common = find_common_crs(infos, options_.assume_crs);
  crs_ = std::move(common.crs);
  warnings_ = std::move(common.warnings);
  const Eigen::Vector3d scale(options_.plan_scale.x(), options_.plan_scale.y(), 1.0);
  for (std::size_t i = 0; i < files_.size(); ++i) {
    files_[i].unit_m = common.unit_m[i].cwiseQuotient(scale);
  }
  refuse_degrees(files_.front());
  find_frame();
  close_if_heavy(files_.front());
}

void CloudFiles::set_bounds(const Eigen::AlignedBox3d& box_in_world) {
  const Eigen::Vector3d& unit_in_world = unit_m();
  options_.bounds_in_file = Eigen::AlignedBox3d(box_in_world.min().cwiseQuotient(unit_in_world),
                                                box_in_world.max().cwiseQuotient(unit_in_world));
}

void CloudFiles::set_plan_scale(const Eigen::Vector2d& scale) {
  options_.plan_scale = scale;
  begin();
}

CloudFiles::~CloudFiles() = default;

void CloudFiles::refuse_degrees(File& file) {
  if (!has_size_of_degrees(open(file))) return;
  throw IoError(
      file.info.path,
      fmt::format(
          "the coordinates look like degrees, {}; project the cloud to a system in metres or feet",
          crs_.known() ? fmt::format("not the metres or feet of \"{}\"", describe(crs_).name)
                       : "and no reference system is given"));
}

void CloudFiles::find_frame() {
  if (options_.frame) {
    frame_ = *options_.frame;
    return;
  }
  for (File& file : files_) {
    const std::optional<LocalFrame> frame = origin_of(open(file), file.unit_m);
    close_if_heavy(file);
    if (!frame) continue;
    frame_ = *frame;
    return;
  }
}

CloudSource& CloudFiles::open(File& file) const {
  if (!file.source) {
    file.source = open_cloud(file.info.path, {.salvage = options_.salvage,
                                              .max_resolution_m = options_.max_resolution_m});
  }
  return *file.source;
}

void CloudFiles::close_if_heavy(File& file) {
  if (file.source && !file.source->is_light()) file.source.reset();
}

LocalFromFile CloudFiles::local_from(const File& file) const {
  return {file.unit_m, frame_.origin_m};
}

bool CloudFiles::is_passed_over(File& file, const PointFilter& filter) const {
  const auto is_outside = [&](const Eigen::AlignedBox3d& box_in_file) {
    return filter.excludes(local_from(file)(box_in_file));
  };
  if (!trusts_headers_) return false;
  if (!file.info.stated_bounds || !is_outside(*file.info.stated_bounds)) return false;
  if (!std::exchange(file.is_checked, true)) file.confirmed_bounds = confirmed_bounds(open(file));
  return file.confirmed_bounds && is_outside(*file.confirmed_bounds);
}

/// Reserves once, so that growth never holds the points twice. Reserved pages that stay unused cost
/// no memory, so an upper bound is good enough for small clouds; the points of large ones are
/// counted first.
void CloudFiles::reserve(const PointFilter& filter, std::uint64_t max_points, PointCloud& cloud) {
  constexpr std::uint64_t kBoundIsGoodEnough = 1U << 25U;  // points; 1 GiB of address space
  const std::uint64_t limit = point_limit(options_);
  std::uint64_t expected = 0;
  for (const File& file : files_) expected += file.info.n_points;
  expected = std::min(expected, max_points);
  if (expected > std::min(limit, kBoundIsGoodEnough)) {
    expected = 0;
    for (File& file : files_) {
      if (is_passed_over(file, filter)) continue;
      expected += count_kept(open(file), local_from(file), filter);
      close_if_heavy(file);
    }
  }
  const std::string& path = files_.front().info.path;
  if (expected > limit) {
    throw IoError(path, fmt::format("the {} points to keep from {} file(s) need {} bytes; the "
                                    "limit is {} points (max_points, max_memory)",
                                    expected, files_.size(), expected * sizeof(CloudPoint), limit));
  }
  try {
    cloud.points.reserve(expected);
    // Huge pages avoid a page fault for every 128 points.
    advise_whole_pages(
        {reinterpret_cast<const std::byte*>(cloud.points.data()), expected * sizeof(CloudPoint)},
        MADV_HUGEPAGE);
  } catch (const std::bad_alloc&) {
    throw IoError(path,
                  fmt::format("the {} points to keep need {} bytes, more than the available memory",
                              expected, expected * sizeof(CloudPoint)));
  }
}

/// Appends the wanted points of a file. Returns false if the cloud then has more than `max_points`.
bool CloudFiles::append(File& file,
                        const PointFilter& filter,
                        std::uint64_t max_points,
                        PointCloud& cloud) {
  const CloudFileInfo& info = file.info;
  const auto warn = [&](const std::string& text) {
    cloud.warnings.push_back(info.path + ": " + text);
  };
  for (const std::string& warning : info.warnings) warn(warning);
  if (is_passed_over(file, filter)) {
    cloud.n_read += info.n_points;
    cloud.n_dropped_bounds += info.n_points;
    return true;
  }
  file.is_read = true;
  const CloudSource& source = open(file);
  const ReadSummary summary =
      append_points(source, local_from(file), filter, cloud.points, max_points);
  if (cloud.points.size() > max_points) {
    close_if_heavy(file);
    return false;
  }
  cloud.n_read += summary.n_read;
  add_drops(summary.drops, cloud);
  if (info.n_points == 0) warn("has no points");
  if (summary.has_whole_extent) {
    if (const auto text = wrong_bounds(info, file.unit_m, summary.extent_in_world)) warn(*text);
  }
  const SeenPoints seen{summary.extent_in_world, summary.steps, summary.n_read};
  if (const auto text = coarse_steps(source, file.unit_m, seen)) {
    if (options_.strict) throw IoError(info.path, *text);
    warn(*text);
  }
  close_if_heavy(file);
  return true;
}

std::optional<PointCloud> CloudFiles::read_files(std::optional<PlanMask> near,
                                                 std::uint64_t max_points) {
  options_.near = std::move(near);
  const PointFilter filter(options_, local_from(files_.front()));
  PointCloud cloud{.frame = frame_, .crs = crs_, .points = {}, .warnings = warnings_};
  cloud.horizontal_unit_m = files_.front().unit_m.x() * options_.plan_scale.x();
  cloud.vertical_unit_m = files_.front().unit_m.z();
  reserve(filter, max_points, cloud);
  for (File& file : files_) {
    if (!append(file, filter, max_points, cloud)) return std::nullopt;
  }
  cloud.warnings = shared_warnings(cloud.warnings);
  return cloud;
}

PointCloud CloudFiles::read(std::optional<PlanMask> near) {
  return *read_files(std::move(near), kNoLimit);
}

std::optional<PointCloud> CloudFiles::read_at_most(std::optional<PlanMask> near,
                                                   std::uint64_t max_points) {
  return read_files(std::move(near), max_points);
}

PointCloud CloudFiles::read_thinned(const std::optional<PlanMask>& near, std::uint64_t max_points) {
  constexpr double kStep = 0.25;
  check(max_points > 0, "read_thinned: max_points = 0, must be at least 1");
  const double share = options_.share;
  std::optional<PointCloud> cloud = read_files(near, max_points);
  while (!cloud) {
    options_.share *= kStep;
    cloud = read_files(near, max_points);
  }
  options_.share = share;
  return std::move(*cloud);
}

std::vector<std::string> CloudFiles::unread_paths() const {
  std::vector<std::string> paths;
  for (const File& file : files_) {
    if (!file.is_read) paths.push_back(file.info.path);
  }
  return paths;
}

Eigen::AlignedBox3d CloudFiles::extent_in_world() {
  options_.near.reset();
  const PointFilter filter(options_, local_from(files_.front()));
  Eigen::AlignedBox3d extent;
  for (File& file : files_) {
    const Eigen::AlignedBox3d box = kept_extent(open(file), local_from(file), filter);
    if (!box.isEmpty()) extent.extend(box.translated(frame_.origin_m));
    close_if_heavy(file);
  }
  return extent;
}

}  // namespace ridgeline::io
