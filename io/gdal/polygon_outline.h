// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace ridgeline::io {

/// The polygons of a file as one outline.
struct PolygonOutline {
  std::vector<Eigen::Vector2d>
      corners;  ///< of the convex hull of all polygons, counter-clockwise, in units of the CRS
  Crs crs;  ///< unknown for a GeoJSON in degrees, which is also the default, whose coordinates are
            ///< not in degrees
};

/// The convex hull of points in plan, counter-clockwise, without points on its sides; fewer than
/// three points if all points are collinear.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// Reads the polygons of all layers of a GeoPackage, GeoJSON or Shapefile; other geometries are
/// ignored. Throws IoError if the file cannot be read, has no polygon with an area, or has layers
/// in different reference systems or non-finite coordinates.
PolygonOutline read_polygon_outline(const std::string& path);

}  // namespace ridgeline::io
