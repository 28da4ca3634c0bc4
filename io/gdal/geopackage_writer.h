// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "io/gdal/attribute_table.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::io {

enum class MapGeometry : std::uint8_t { kPoint, kLine, kPolygon, kMultiPolygon };

struct MapFeature {
  /// Vertices in the map's CRS; one for a point. A polygon's ring need not be closed. Without
  /// vertices the feature has no geometry.
  std::vector<Eigen::Vector3d> vertices;
  SparseRow values;
  /// Only for a multi-polygon, instead of `vertices`: the rings of each polygon, the outer one
  /// first.
  std::vector<std::vector<std::vector<Eigen::Vector3d>>> polygons = {};
};

/// Default style of a layer for QGIS (qml) and other programs (sld).
struct MapStyle {
  std::string name, qml, sld;
};

struct MapLayer {
  std::string name;
  std::string description;
  MapGeometry geometry = MapGeometry::kLine;
  std::vector<Column> columns;
  std::vector<MapFeature> features;
  MapStyle style;
};

/// Writes a GeoPackage of 3D layers with their styles (table `layer_styles`, as QGIS reads it).
/// Layer and column names must be unique regardless of case; features are numbered from 1. Bytes
/// that are not UTF-8 are read as Latin-1. The same map gives the same bytes. The file is written
/// completely or not at all. Throws IoError if it cannot be written.
void write_geopackage(const std::string& path, const Crs& crs, const std::vector<MapLayer>& layers);

}  // namespace ridgeline::io
