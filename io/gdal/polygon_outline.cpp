// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/polygon_outline.h"

#include "io/error.h"
#include "io/gdal/ogr_support.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <tuple>

namespace ridgeline::io {
namespace {

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

void add_ring(const OGRLinearRing& ring, std::vector<Eigen::Vector2d>& points) {
  for (int i = 0; i < ring.getNumPoints(); ++i) points.emplace_back(ring.getX(i), ring.getY(i));
}

void add_polygons(const OGRGeometry& geometry, std::vector<Eigen::Vector2d>& points) {
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPolygon:
      if (const OGRLinearRing* ring = geometry.toPolygon()->getExteriorRing())
        add_ring(*ring, points);
      return;
    case wkbMultiPolygon:
    case wkbGeometryCollection:
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) add_polygons(*part, points);
      return;
    default:
      return;
  }
}

GDALDatasetUniquePtr open_vectors(const std::string& path, const QuietGdal& quiet) {
  if (!std::filesystem::exists(path)) throw MissingFileError(path, "does not exist");
  register_gdal_drivers();
  const char* const drivers[] = {"GPKG", "GeoJSON", "ESRI Shapefile", nullptr};
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
  if (!dataset) {
    throw IoError(path, "is not a readable GeoPackage, GeoJSON or Shapefile with polygons: " +
                            quiet.complaints("the content has none of these formats"));
  }
  return dataset;
}

/// GDAL takes a GeoJSON without `crs` to be in WGS 84, as RFC 7946 says. Programs that use the
/// older format also omit `crs` for coordinates in metres.
bool is_beyond_degrees(const std::vector<Eigen::Vector2d>& points) {
  return std::ranges::any_of(points, [](const Eigen::Vector2d& x) {
    return std::abs(x.x()) > 180.0 || std::abs(x.y()) > 90.0;
  });
}

}  // namespace

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::ranges::sort(points, {}, [](const Eigen::Vector2d& x) { return std::tuple(x.x(), x.y()); });
  // Andrew's monotone chain: the lower side from left to right, then the upper one back.
  std::vector<Eigen::Vector2d> hull;
  const auto add_side = [&hull](const auto& side) {
    const std::size_t first = hull.size();
    for (const Eigen::Vector2d& x : side) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), x) <= 0.0)
        hull.pop_back();
      hull.push_back(x);
    }
    if (!hull.empty()) hull.pop_back();  // the other side begins with this corner
  };
  add_side(points);
  std::ranges::reverse(points);
  add_side(points);
  return hull;
}

PolygonOutline read_polygon_outline(const std::string& path) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr dataset = open_vectors(path, quiet);
  PolygonOutline outline;
  std::vector<Eigen::Vector2d> points;
  for (OGRLayer* layer : dataset->GetLayers()) {
    const std::size_t n_before = points.size();
    for (const auto& feature : *layer) {
      if (const OGRGeometry* geometry = feature->GetGeometryRef()) add_polygons(*geometry, points);
    }
    if (points.size() == n_before) continue;
    const Crs crs = crs_of(layer->GetSpatialRef());
    if (n_before > 0 && crs.definition != outline.crs.definition)
      throw IoError(path,
                    "has polygon layers with different reference systems; use a single layer");
    outline.crs = crs;
  }
  const bool is_geojson = dataset->GetDriver()->GetDescription() == std::string_view("GeoJSON");
  if (is_geojson && describe(outline.crs).is_geographic && is_beyond_degrees(points))
    outline.crs = {};
  if (!std::ranges::all_of(points, [](const Eigen::Vector2d& x) { return x.allFinite(); }))
    throw IoError(path, "has a polygon with non-finite coordinates");
  outline.corners = convex_hull(std::move(points));
  if (outline.corners.size() < 3) throw IoError(path, "has no polygon with an area");
  return outline;
}

}  // namespace ridgeline::io
