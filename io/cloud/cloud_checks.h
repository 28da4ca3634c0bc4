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

/// A warning about steps of the coordinates above `tolerable_m`, metres; nothing if there are none.
/// The steps come from the values, the scale of LAS or float32, and the digits that they cost are
/// lost for good. In plan, a raster with one height a cell may have such steps.
std::optional<std::string> coarse_steps(const CloudSource& source,
                                        const Eigen::Vector3d& unit_m,
                                        const SeenPoints& points,
                                        double tolerable_m = kMaxCoordinateStep_m);
/// A warning about header bounds that differ from the extent of the points; nothing if they agree
/// or none are stated.
std::optional<std::string> wrong_bounds(const CloudFileInfo& info,
                                        const Eigen::Vector3d& unit_m,
                                        const Eigen::AlignedBox3d& extent_in_world);

/// The bounds that the header states, with a small margin, file units. They are returned if they
/// enclose an area and hold the points of the first block, the last one and some between. Nothing
/// is returned for a file that has an index of its own or whose blocks cannot be decoded in any
/// order. Throws IoError for a damaged block.
std::optional<Eigen::AlignedBox3d> confirmed_bounds(const CloudSource& source);

}  // namespace ridgeline::io
