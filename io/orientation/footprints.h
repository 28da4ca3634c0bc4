// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The intersection of an image's border with the horizontal plane at a height: eight points, the
/// corners and midpoints of the sides, corrected for lens distortion, clockwise in the image from
/// its top-left corner. std::nullopt for an image without camera or size, for one whose distortion
/// has no inverse at its border, and if a border ray points too near the horizon or above it.
std::optional<std::vector<Eigen::Vector3d>> footprint(const Orientation& orientation,
                                                      const OrientedImage& image,
                                                      double height_m);

/// Writes a plan of the block as GeoPackage: `footprints` at ground height, `cameras` (position,
/// angles in degrees), and `overlap`, about 2,500 cells with the number of images that see their
/// centres. Throws IoError if no image has a footprint or the file cannot be written.
void write_orientation_map(const std::string& path,
                           const Orientation& orientation,
                           double ground_height_m);

}  // namespace ridgeline::io
