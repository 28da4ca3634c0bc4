// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <string>
#include <string_view>

namespace ridgeline::io {

// One reader per format: from a file's content to its lines, format name and CRS. read_lines() does
// what is common to all formats (CRS override, checks on coordinates). `path` is used in messages.

LineSet read_geojson(const std::string& path, std::string_view content);

/// Reads a table. With a header it has columns x1..z2 or a column of WKT, in any order; without
/// one, six numbers per row. The separator is a semicolon, a tab, a comma, | or blanks.
LineSet read_csv(const std::string& path, std::string_view content);

/// Reads one geometry per row: LINESTRING Z or MULTILINESTRING Z, also EWKT with SRID.
LineSet read_wkt(const std::string& path, std::string_view content);

/// Reads the `l` records. If they only repeat the outlines of faces, or there are none, each
/// distinct edge of the `f` polygons is read once. In ELSR's files, whose `l` records start at a
/// wrong index, consecutive pairs of vertices are the lines.
LineSet read_obj(const std::string& path, std::string_view content, bool vertex_pairs);

/// Reads edge elements, ascii or binary; without them, each distinct edge of the faces once.
LineSet read_ply(const std::string& path, std::string_view content);

/// Reads a GeoPackage, Shapefile or DXF. `lod`: see ReadModelOptions::lod; it selects among the
/// layers lod12_3d, lod22_3d, ... of a GeoPackage.
LineSet read_ogr(const std::string& path, std::string_view extension, const std::string& lod);

LineSet read_line3dpp(const std::string& path, std::string_view content);
LineSet read_limap_tracks(const std::string& path, std::string_view content);
LineSet read_limap_track(const std::string& path, std::string_view content);
LineSet read_limap_folder(const std::string& path);
LineSet read_space_lines(const std::string& path, std::string_view content);

}  // namespace ridgeline::io
