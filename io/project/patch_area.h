// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "io/files/yaml_check.h"

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The corners of the area given by a patch's key `area`: bounds [x_min, y_min, x_max, y_max],
/// metres, or a file whose polygons read_polygon_outline() reads. Counter-clockwise, metres in the
/// CRS of the patch; empty without the key. Warns about a file without a CRS. Throws IoError for
/// bounds without an area, and for a file whose CRS differs from the patch's.
std::vector<Eigen::Vector2d> area_of_patch(const YamlMap& patch,
                                           const std::filesystem::path& folder,
                                           const Crs& crs,
                                           std::vector<std::string>& warnings);

}  // namespace ridgeline::io
