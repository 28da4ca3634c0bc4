// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/crs/coordinate_steps.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace ridgeline::io {

/// What the points of a file have shown, in metres.
struct SeenPoints {
  Eigen::AlignedBox3d extent_in_world;
  CoordinateSteps steps;
  std::uint64_t n = 0;
};

/// What deserves a warning about the points of a file; nothing if all is well.
///
/// Steps of the coordinates above `tolerable_m`, by their values, by the scale of LAS or by float32: digits are
/// lost that nothing brings back. The plan of a raster with one height a cell has its steps by right.
std::optional<std::string> coarse_steps(const CloudSource& source,
                                        const Eigen::Vector3d& unit_m,
                                        const SeenPoints& points,
                                        double tolerable_m = kMaxCoordinateStep_m);
std::optional<std::string> wrong_bounds(const CloudFileInfo& info,
                                        const Eigen::Vector3d& unit_m,
                                        const Eigen::AlignedBox3d& extent_in_world);

/// The bounds that a header states, file units, if they enclose an area and hold the points of the
/// first, the last and some blocks between. None for a file that has an index of its own, or no random access.
/// Throws IoError for a damaged block.
std::optional<Eigen::AlignedBox3d> confirmed_bounds(const CloudSource& source);

}  // namespace ridgeline::io
