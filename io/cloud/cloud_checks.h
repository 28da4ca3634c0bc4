// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/cloud/read_cloud.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace ridgeline::io {

/// What deserves a warning about the points of a file, once their extent is known (world, metres);
/// nothing if all is well. Coordinates that went through float32 have lost digits that nothing brings
/// back.
std::optional<std::string> float_damage(const CloudFileInfo& info,
                                        const Eigen::AlignedBox3d& extent_in_world,
                                        const ReadOptions& options);
std::optional<std::string> wrong_bounds(const CloudFileInfo& info,
                                        const Eigen::Vector3d& unit_m,
                                        const Eigen::AlignedBox3d& extent_in_world);

/// The bounds that a header states, file units, if they enclose an area and hold the points of the
/// first and the last block. None for a file that has an index of its own, or no random access.
/// Throws IoError for a damaged block.
std::optional<Eigen::AlignedBox3d> confirmed_bounds(const CloudSource& source);

}  // namespace ridgeline::io
