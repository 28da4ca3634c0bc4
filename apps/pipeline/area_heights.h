// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/surface_heights.h"
#include "io/project/patch.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
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
  std::vector<Eigen::Vector3d> points_in_world;  ///< with a possible height
  std::size_t n_impossible = 0;                  ///< points with another height
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

/// Warns about impossible heights (io::is_possible_height()), which are treated as missing.
/// `n_possible`: the number of the other heights.
std::optional<std::string> impossible_heights(const io::ProjectFile& project,
                                              std::size_t n_impossible,
                                              std::size_t n_possible);

/// The cells of the project's surface model within an area. Throws IoError for a model that cannot
/// be read or has a different CRS.
io::SurfaceHeights model_heights(const io::ProjectFile& project, const Eigen::AlignedBox2d& area_m);

/// Throws IoError: the surface model has no heights in an area.
[[noreturn]] void refuse_model(const io::ProjectFile& project, const Eigen::AlignedBox2d& area_m);

/// The heights from which `height_range: auto` of a patch is derived, m: those of surface model
/// cells or LIDAR points, see decide_patch(). Throws IoError if there are none, and for a surface
/// model without an area.
std::vector<double> area_heights_m(const io::PatchFile& patch, std::vector<std::string>& warnings);

}  // namespace ridgeline::apps
