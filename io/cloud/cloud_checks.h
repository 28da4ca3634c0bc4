// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/crs/coordinate_steps.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace ridgeline::io {

/// Extent, coordinate steps and number of the points read from a file; metres.
struct SeenPoints {
  Eigen::AlignedBox3d extent_in_world;
  CoordinateSteps steps;
  std::uint64_t n = 0;
};

/// Returns a warning if coordinates are quantised in steps above `tolerable_m`, metres; otherwise
/// std::nullopt. The steps arise from the values, the LAS scale or float32, and the lost digits
/// cannot be recovered. In plan, such steps are allowed for a raster with one height per cell.
std::optional<std::string> coarse_steps(const CloudSource& source,
                                        const Eigen::Vector3d& unit_m,
                                        const SeenPoints& points,
                                        double tolerable_m = kMaxCoordinateStep_m);
/// Returns a warning if the header bounds differ from the extent of the points; std::nullopt if
/// they agree or no bounds are stated.
std::optional<std::string> wrong_bounds(const CloudFileInfo& info,
                                        const Eigen::Vector3d& unit_m,
                                        const Eigen::AlignedBox3d& extent_in_world);

/// The bounds stated by the header, with a small margin, file units. They are returned only if they
/// enclose an area and contain the points of the first block, the last block and some in between.
/// Returns std::nullopt for a file that has its own index or whose blocks cannot be decoded in any
/// order. Throws IoError if a block is damaged.
std::optional<Eigen::AlignedBox3d> confirmed_bounds(const CloudSource& source);

}  // namespace ridgeline::io
