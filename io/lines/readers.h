// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <string>
#include <string_view>

namespace ridgeline::io {

// One reader per format: from a file's content to its lines, format name and CRS. What is the same
// for all formats (CRS override, checks on coordinates) is read_lines()'s. `path` serves messages.

LineSet read_geojson(const std::string& path, std::string_view content);

/// With header: columns x1..z2 or a column of WKT, in any order. Without: six numbers a row.
/// Separator: comma, semicolon or tab.
LineSet read_csv(const std::string& path, std::string_view content);

/// One geometry a row: LINESTRING Z or MULTILINESTRING Z, also EWKT with SRID.
LineSet read_wkt(const std::string& path, std::string_view content);

/// `l` records; where they only repeat outlines of faces, or there are none, each distinct edge of
/// the `f` polygons once. ELSR's files, whose `l` records start at a wrong index: vertices two by
/// two.
LineSet read_obj(const std::string& path, std::string_view content, bool vertex_pairs);

/// Edge elements, ascii or binary; without them each distinct edge of the faces once.
LineSet read_ply(const std::string& path, std::string_view content);

/// GeoPackage, Shapefile, DXF.
LineSet read_ogr(const std::string& path, std::string_view extension);

LineSet read_line3dpp(const std::string& path, std::string_view content);
LineSet read_limap_tracks(const std::string& path, std::string_view content);
LineSet read_limap_track(const std::string& path, std::string_view content);
LineSet read_limap_folder(const std::string& path);
LineSet read_space_lines(const std::string& path, std::string_view content);

}  // namespace ridgeline::io
