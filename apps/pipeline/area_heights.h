// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::apps {

/// Margin below and above the heights, m.
constexpr double kHeightMargin_m = 10.0;

/// The lowest and highest height; groups with fewer than a thousandth of the heights that are more
/// than kHeightMargin_m from all others are ignored. `heights_m` must not be empty.
std::array<double, 2> height_limits_m(std::span<const double> heights_m);

/// The height range to be searched: height_limits_m() with kHeightMargin_m on both sides.
std::array<double, 2> height_range_m(std::span<const double> heights_m);

/// A sample of the LIDAR, at most 2 million points.
struct LidarSample {
  std::vector<Eigen::Vector3d> points_in_world;
  io::Crs crs;
};

/// A sample of the project's LIDAR; if there is an area, of its bounding box grown by `margin_m`.
/// Throws IoError for clouds that cannot be read.
LidarSample lidar_sample(const io::ProjectFile& project, double margin_m = 0.0);

/// Throws IoError: no LIDAR point lies `where`; the message also says whether the CRS may be the
/// reason.
[[noreturn]] void refuse_lidar(const io::ProjectFile& project,
                               const LidarSample& lidar,
                               const char* where);

/// The heights of the cells of the project's surface model within an area, m. Throws IoError for a
/// model that cannot be read or has a different CRS, and if there is no area.
std::vector<double> model_heights_m(const io::ProjectFile& project,
                                    const std::vector<Eigen::Vector2d>& area_m);

/// The heights from which `height_range: auto` of a patch is derived, m: those of surface model
/// cells or LIDAR points, see decide_patch(). Throws IoError if there are none.
std::vector<double> area_heights_m(const io::PatchFile& patch);

}  // namespace ridgeline::apps
