// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Where the border of an image meets the horizontal plane at a height: eight points, corners and
/// middles of sides, lens included, clockwise in the image from its top-left corner. Nothing for an
/// image without camera or size, for one whose distortion has no inverse at its border, and where a
/// side looks at the horizon or above it.
std::optional<std::vector<Eigen::Vector3d>> footprint(const Orientation& orientation,
                                                      const OrientedImage& image,
                                                      double height_m);

/// Writes a plan of the block as GeoPackage: `footprints` at the height of the ground, `cameras`
/// (position, angles in degrees), and `overlap`, cells with the number of images that see their
/// middle (about 2,500 cells). Throws IoError if no image has a footprint or the file cannot be
/// written.
void write_orientation_map(const std::string& path,
                           const Orientation& orientation,
                           double ground_height_m);

}  // namespace ridgeline::io
