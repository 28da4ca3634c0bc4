// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/plan_mask.h"
#include "io/cloud/point_cloud.h"
#include "io/files/expand_patterns.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

struct ReadOptions {
  /// Classes to keep; unset keeps all but 7 and 18 (noise).
  std::optional<std::set<std::uint8_t>> classes;
  bool exclude_withheld = true;  ///< points that the producer marked as not to be used
  bool last_returns = false;     ///< keep only the last return of each pulse
  /// Box of the points to keep, in the cloud's own coordinates, borders included.
  std::optional<Eigen::AlignedBox3d> bounds_in_file;
  std::optional<PlanMask> near;     ///< keep only points in the mask; needs `frame`
  std::optional<LocalFrame> frame;  ///< unset: suggest_frame() of the first file with points
  Crs assume_crs;                   ///< declares or overrides the CRS of every file
  /// Coordinates of the plan are divided by these to be metres on the ground, see GridScale.
  Eigen::Vector2d plan_scale = Eigen::Vector2d::Ones();
  /// Share of the points to keep. They are chosen evenly by their coordinates, so their order does
  /// not matter.
  double share = 1.0;
  std::uint64_t max_points = 0;        ///< kept points allowed; 0: no limit
  std::uint64_t max_memory_bytes = 0;  ///< for kept points, 32 bytes each; 0: no limit
  /// Whether coordinates in steps above kMaxCoordinateStep_m are refused; otherwise there is a
  /// warning.
  bool strict = false;
  bool salvage = false;  ///< read the records that are there when a file is cut short
  /// Only the levels of a COPC octree down to this distance between points are read;
  /// 0: all. Other files are read whole.
  double max_resolution_m = 0.0;
};

/// A box of all heights for ReadOptions::bounds_in_file, of x_min, y_min, x_max, y_max.
/// Throws std::invalid_argument for other than four numbers, and for inverted ones or NaN.
Eigen::AlignedBox3d plan_bounds(std::span<const double> bounds);

/// The points of all files as one cloud, in metres in one local frame: files in the order given
/// (those of a pattern with * ? [ ] sorted by name), points in file order whatever the number of
/// threads. Feet are converted by the CRS's stated factor; degrees are refused. At most 32 bytes a
/// kept point are held beside a few MB of blocks.
///
/// Files may state different descriptions of one CRS; really different ones are refused. A dropped
/// point is counted once, by the first of these reasons: not finite, withheld, class, return,
/// bounds, share. COPC nodes outside the bounds or the mask are not decoded; all their points count
/// as out of bounds.
///
/// Throws IoError for a file's fault (also a pattern without a match, a coordinate beyond 1e8 m,
/// too many points), and std::invalid_argument for a fault of an option.
PointCloud read_cloud(const std::vector<std::string>& paths_or_patterns,
                      const ReadOptions& options = {});

/// The frame of a run without a given origin. Its origin is the median position of a sample of the
/// first file that has points, rounded to 100 m by axis. Points are sampled, as header bounds may
/// be wrong.
LocalFrame suggest_frame(const std::vector<std::string>& paths_or_patterns,
                         const ReadOptions& options = {});

}  // namespace ridgeline::io
