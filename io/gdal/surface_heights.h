// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Whether a surface can have this height. Files mark missing heights by values such as -9999,
/// -32768 and 3.4e38, often without stating this.
bool is_possible_height(double height_m);

/// The heights of a surface model, a single-band raster of heights in the unit of its vertical
/// reference system; in metres without one.
struct SurfaceHeights {
  std::vector<double> heights_m;  ///< of the cells within the bounds that have a possible height
  std::size_t n_impossible = 0;   ///< cells within the bounds that have another height
  Crs crs;
};

/// Reads the cells of a GeoTIFF or ASCII grid whose centres lie within the bounds (units of its
/// reference system); at most about four million of them, evenly distributed. Throws IoError if the
/// file cannot be read or has no georeference or a rotated one.
SurfaceHeights read_surface_heights(const std::string& path, const Eigen::AlignedBox2d& bounds);

/// The files that are read with a surface model, such as .prj, .tfw and .aux.xml. Throws IoError if
/// the surface model cannot be opened.
std::vector<std::string> files_beside_surface_model(const std::string& path);

}  // namespace ridgeline::io
