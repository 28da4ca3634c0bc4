// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/cloud/point_filter.h"
#include "io/cloud/read_cloud.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The files of one cloud. Headers are read once; points are read on each request, for example
/// around one group of lines after another. A file is skipped if its header bounds show that it has
/// no wanted points. Headers are often wrong, so the bounds are used only if points from some of
/// the file's blocks confirm them, and only until distrust_headers() is called.
class CloudFiles {
 public:
  /// Opens every file. `options.near` is ignored: a mask is passed to each read function. Throws
  /// under the same conditions as read_cloud().
  CloudFiles(const std::vector<std::string>& paths_or_patterns, const ReadOptions& options);
  /// Takes a cloud that is already open, such as one in memory. Throws std::invalid_argument unless
  /// CloudSource::is_light() holds.
  CloudFiles(std::unique_ptr<CloudSource> source, const ReadOptions& options);
  ~CloudFiles();

  /// The frame given by the options, otherwise the one from the origin rule of suggest_frame().
  [[nodiscard]] const LocalFrame& frame() const { return frame_; }

  [[nodiscard]] const Crs& crs() const { return crs_; }

  /// Sets ReadOptions::bounds_in_file from a box in metres.
  void set_bounds(const Eigen::AlignedBox3d& box_in_world);

  /// Sets ReadOptions::plan_scale, which depends on the location of the data. This also updates
  /// frame and units.
  void set_plan_scale(const Eigen::Vector2d& scale);
  [[nodiscard]] const Eigen::Vector2d& plan_scale() const { return options_.plan_scale; }

  /// The path of the first file.
  [[nodiscard]] const std::string& path() const { return files_.front().info.path; }

  /// Metres on the ground per coordinate unit by axis, from the CRS, otherwise from the first
  /// file's own unit keys.
  [[nodiscard]] const Eigen::Vector3d& unit_m() const { return files_.front().unit_m; }

  /// Reads the points that the options keep and that lie in the mask, if there is one. Order,
  /// units, counts and errors are as for read_cloud().
  PointCloud read(std::optional<PlanMask> near);

  /// The points of read(), or std::nullopt if there are more than `max_points`. Memory holds no
  /// more than that many points and a few blocks.
  std::optional<PointCloud> read_at_most(std::optional<PlanMask> near, std::uint64_t max_points);

  /// The points of read() at the largest share that yields at most `max_points`. The shares tried
  /// are 1, 1/4, 1/16, ... times the options' share.
  PointCloud read_thinned(const std::optional<PlanMask>& near, std::uint64_t max_points);

  /// From this call on, no file is skipped because of its header.
  void distrust_headers() { trusts_headers_ = false; }

  /// The files that have been skipped in every reading so far.
  [[nodiscard]] std::vector<std::string> unread_paths() const;

  /// The box of the points that the options keep, metres; empty if there are none. Reads all files.
  [[nodiscard]] Eigen::AlignedBox3d extent_in_world();

 private:
  struct File {
    CloudFileInfo info;
    Eigen::Vector3d unit_m = Eigen::Vector3d::Ones();
    std::unique_ptr<CloudSource> source;  ///< null while the file is closed
    bool is_read = false;
    bool is_checked = false;
    /// The header's bounds, file units; set if the file's points confirm them.
    std::optional<Eigen::AlignedBox3d> confirmed_bounds;
  };

  void begin();
  void refuse_degrees(File& file);
  void find_frame();
  CloudSource& open(File& file) const;
  static void close_if_heavy(File& file);
  [[nodiscard]] LocalFromFile local_from(const File& file) const;
  bool is_passed_over(File& file, const PointFilter& filter) const;
  void reserve(const PointFilter& filter, std::uint64_t max_points, PointCloud& cloud);
  bool append(File& file, const PointFilter& filter, std::uint64_t max_points, PointCloud& cloud);
  std::optional<PointCloud> read_files(std::optional<PlanMask> near, std::uint64_t max_points);

  ReadOptions options_;
  LocalFrame frame_;
  Crs crs_;
  std::vector<std::string> warnings_;
  std::vector<File> files_;
  bool trusts_headers_ = true;
};

}  // namespace ridgeline::io
