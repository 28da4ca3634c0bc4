// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::apps {

/// Added to both sides of the heights, m.
constexpr double kHeightMargin_m = 10.0;

/// The lowest and the highest height; groups that hold fewer than a thousandth of the heights and
/// are more than kHeightMargin_m from all others are left out. `heights_m` must not be empty.
std::array<double, 2> height_limits_m(std::span<const double> heights_m);

/// The heights to be searched: height_limits_m() with kHeightMargin_m on both sides.
std::array<double, 2> height_range_m(std::span<const double> heights_m);

/// A sample of the LIDAR, at most 2 million points.
struct LidarSample {
  std::vector<Eigen::Vector3d> points_in_world;
  io::Crs crs;
};

/// A sample of the project's LIDAR; with an area, of the box around it, grown by `margin_m`. Throws
/// IoError for clouds that cannot be read.
LidarSample lidar_sample(const io::ProjectFile& project, double margin_m = 0.0);

/// Says that no point of the LIDAR lies `where`, and whether its CRS may be the reason.
[[noreturn]] void refuse_lidar(const io::ProjectFile& project,
                               const LidarSample& lidar,
                               const char* where);

/// The heights of the cells of the project's surface model within an area, m. Throws IoError for a
/// model that cannot be read or has another CRS, and without an area.
std::vector<double> model_heights_m(const io::ProjectFile& project,
                                    const std::vector<Eigen::Vector2d>& area_m);

/// The heights that `height_range: auto` of a patch is about, m: of cells of the surface model or
/// of LIDAR points, see decide_patch(). Throws IoError if there are none.
std::vector<double> area_heights_m(const io::PatchFile& patch);

}  // namespace ridgeline::apps
