// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace ridgeline::io {

struct ReadLinesOptions {
  Crs assume_crs = {};  ///< declares or overrides the file's CRS; unknown: the file decides
  /// Metres per coordinate unit by axis, for a file that states no CRS; unset: metres.
  std::optional<Eigen::Vector3d> unit_m = std::nullopt;
  Eigen::Vector2d plan_scale = Eigen::Vector2d::Ones();  ///< see LineSet::plan_scale
  std::string lod = {};  ///< for building models, see ReadModelOptions::lod
  std::string id_column = {}, building_column = {};  ///< see name_by_columns()
  bool vertex_pairs = false;  ///< whether consecutive pairs of vertices of an OBJ are the segments
};

/// Reads the 3D lines of any tool; the format is detected from extension and content:
///   GeoJSON, GeoPackage, Shapefile, DXF, WKT, CSV (x1,y1,z1,x2,y2,z2 or a WKT column), OBJ and PLY
///   (edges, else the edges of faces), Line3D++ .txt, LIMAP alltracks.txt and track_K.txt (or their
///   folder), ELSR .obj and ELSR++ spaceLines.txt.
/// The lines of a building model (CityJSON, CityGML), which is recognised by its content, are the
/// edges of its roofs, see lines_of_model(). Lines in collections are read, too. If a file has
/// polygons with heights but no 3D lines, the edges of the polygons are the lines. Lines keep the
/// file's order and ids, which are made unique; polylines become segments "ID.0", "ID.1", ...
/// between their bends. A line with coordinates that are not finite stays in the set. `warnings`
/// reports what deserves attention and counts anything in the file other than lines. An empty set
/// is valid. Throws IoError for a file that cannot be read, or that has no 3D lines but other
/// contents, which the message counts. Formats that lack what judging requires are rejected by
/// name: Line3D++ .bin, LIMAP .npy, Shapefiles without z, coordinates in degrees.
LineSet read_lines(const std::string& path, const ReadLinesOptions& options = {});

}  // namespace ridgeline::io
