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
  /// Of a multi-polygon, in place of `vertices`: each polygon by its rings, the outer one first.
  std::vector<std::vector<std::vector<Eigen::Vector3d>>> polygons = {};
};

/// How QGIS (qml) and other programs (sld) draw a layer at first.
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
/// Layer and column names must differ without regard to case; features are numbered from 1. Text
/// that is no UTF-8 is taken as Latin-1. The same map gives the same bytes. Written whole or not at
/// all. Throws IoError if the file cannot be written.
void write_geopackage(const std::string& path, const Crs& crs, const std::vector<MapLayer>& layers);

}  // namespace ridgeline::io
