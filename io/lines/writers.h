// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/lines/write_lines.h"

#include <memory>
#include <string>

namespace ridgeline::io {

// The whole text of a file. CSV, OBJ and PLY cannot represent coordinates that are not finite.
std::string csv_text(const LineSet& set);
std::string wkt_csv_text(const LineSet& set);
/// The text of an OBJ or PLY file. All coordinates must be finite; `origin` is stated in the file
/// and subtracted from them.
std::string obj_text(const LineSet& set, const Eigen::Vector3d& origin);
std::string ply_text(const LineSet& set, const Eigen::Vector3d& origin);

std::unique_ptr<LineWriter> geojson_writer(const std::string& path, const Crs& crs);
/// The writer of a GeoPackage, Shapefile or DXF.
std::unique_ptr<LineWriter> ogr_writer(const std::string& path, const Crs& crs, LineFormat format);

}  // namespace ridgeline::io
