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
  bool exclude_withheld = true;  ///< drop points that the producer marked as unusable
  bool last_returns = false;     ///< keep only the last return of each pulse
  /// Box of the points to keep, in the cloud's own coordinates, borders included.
  std::optional<Eigen::AlignedBox3d> bounds_in_file;
  std::optional<PlanMask> near;     ///< keep only points in the mask; needs `frame`
  std::optional<LocalFrame> frame;  ///< unset: suggest_frame() of the first file with points
  Crs assume_crs;                   ///< declares or overrides the CRS of every file
  /// Plan coordinates are divided by these to obtain metres on the ground, see GridScale.
  Eigen::Vector2d plan_scale = Eigen::Vector2d::Ones();
  /// Share of the points to keep. The points are selected uniformly by a hash of their coordinates,
  /// so their order does not matter.
  double share = 1.0;
  std::uint64_t max_points = 0;        ///< maximum number of kept points; 0: no limit
  std::uint64_t max_memory_bytes = 0;  ///< maximum for kept points, 32 bytes each; 0: no limit
  /// Whether coordinates in steps above kMaxCoordinateStep_m are rejected; otherwise there is a
  /// warning.
  bool strict = false;
  bool salvage = false;  ///< read the records that are present if a file is truncated
  /// Only the levels of a COPC octree down to this distance between points are read; 0: all. Other
  /// files are read completely.
  double max_resolution_m = 0.0;
};

/// A box that spans all heights, for ReadOptions::bounds_in_file, from x_min, y_min, x_max, y_max.
/// Throws std::invalid_argument unless there are four numbers, and if they are inverted or NaN.
Eigen::AlignedBox3d plan_bounds(std::span<const double> bounds);

/// Reads the points of all files as one cloud, in metres in one local frame: files in the order
/// given (those of a pattern with * ? [ ] sorted by name), points in file order, regardless of the
/// number of threads. Feet are converted by the factor stated in the CRS; degrees are rejected.
/// Memory use is at most 32 bytes per kept point plus a few MB of blocks.
///
/// Files may describe the same CRS differently; different CRSs are rejected. A dropped point is
/// counted once, by the first of these reasons: not finite, withheld, class, return, bounds, share.
/// COPC nodes outside the bounds or the mask are not decoded; all their points are counted as out
/// of bounds.
///
/// Throws IoError for a faulty file (including an unmatched pattern, a coordinate beyond 1e8 m, or
/// too many points), and std::invalid_argument for an invalid option.
PointCloud read_cloud(const std::vector<std::string>& paths_or_patterns,
                      const ReadOptions& options = {});

/// The frame for a run whose origin is not given. Its origin is the median position of a sample of
/// points from the first file that has any, rounded to 100 m per axis. Points are sampled because
/// header bounds may be wrong.
LocalFrame suggest_frame(const std::vector<std::string>& paths_or_patterns,
                         const ReadOptions& options = {});

}  // namespace ridgeline::io
