// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/lines/write_lines.h"

#include <string>

namespace ridgeline::io {

// One writer per format: the whole text of the file. CSV, OBJ and PLY have no place for coordinates that are not
// finite.
std::string geojson_text(const LineSet& set);
std::string csv_text(const LineSet& set);
std::string wkt_csv_text(const LineSet& set);
/// The text of an OBJ or PLY file. All coordinates must be finite; `origin` is stated and subtracted from them.
std::string obj_text(const LineSet& set, const Eigen::Vector3d& origin);
std::string ply_text(const LineSet& set, const Eigen::Vector3d& origin);

/// Writes a GeoPackage, Shapefile or DXF to `draft`, which must not exist. Throws IoError naming `path`, the file
/// that the draft will become.
void write_ogr(const std::string& path,
               const std::string& draft,
               const LineSet& set,
               LineFormat format);

}  // namespace ridgeline::io
