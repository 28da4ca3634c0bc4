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
  std::string lod = {};  ///< of models of buildings, see ReadModelOptions::lod
  std::string id_column = {}, building_column = {};  ///< see name_by_columns()
  bool vertex_pairs = false;  ///< whether the vertices of an OBJ, two by two, are the segments
};

/// Reads 3D lines of any tool; the format is told by extension and content:
///   GeoJSON, GeoPackage, Shapefile, DXF, WKT, CSV (x1,y1,z1,x2,y2,z2 or a WKT column), OBJ and PLY
///   (edges, else the edges of faces), Line3D++ .txt, LIMAP alltracks.txt and track_K.txt (or their
///   folder), ELSR .obj and ELSR++ spaceLines.txt.
/// The lines of a model of buildings (CityJSON, CityGML) are the edges of its roofs, see
/// lines_of_model(); its content tells that it is one. Lines in collections are read, too. If a
/// file holds polygons with heights and no 3D line, their edges are the lines. Lines keep the
/// file's order and ids, which are made unique; polylines become segments "ID.0", "ID.1", ...
/// between their bends. A line with coordinates that are not finite stays in the set. What deserves
/// attention is in `warnings`, and what the file holds beside lines is counted there. No lines at
/// all is a valid file. Throws IoError for a file that cannot be read, or that holds no 3D lines
/// but other things, which the message counts. Formats that cannot carry what a judgement needs are
/// refused by name: Line3D++ .bin, LIMAP .npy, Shapefiles without z, coordinates in degrees.
LineSet read_lines(const std::string& path, const ReadLinesOptions& options = {});

}  // namespace ridgeline::io
