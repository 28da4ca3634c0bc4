// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/ogr_geometry.h"

#include "reconstruct/geometry/transformed.h"

#include <limits>
#include <memory>
#include <vector>

namespace ridgeline::io {
namespace {

Vertices vertices_of(const OGRLineString& line) {
  Vertices vertices;
  const bool has_z = line.Is3D() != 0;
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const double z = has_z ? line.getZ(i) : std::numeric_limits<double>::quiet_NaN();
    vertices.emplace_back(line.getX(i), line.getY(i), z);
  }
  return vertices;
}

std::vector<Vertices> rings_of(const OGRPolygon& polygon) {
  return transformed(polygon, [&](const OGRLinearRing* ring) { return vertices_of(*ring); });
}

}  // namespace

void collect_geometry(const OGRGeometry& geometry, FeatureGeometry& found) {
  // Arcs and compound curves become line strings; everything else stays as it is.
  const std::unique_ptr<OGRGeometry> linear(geometry.getLinearGeometry());
  switch (wkbFlatten(linear->getGeometryType())) {
    case wkbLineString:
      found.lines.push_back(vertices_of(*linear->toLineString()));
      break;
    case wkbPolygon:
    case wkbTriangle:
      found.add_polygon(rings_of(*linear->toPolygon()));
      break;
    case wkbPolyhedralSurface:
    case wkbTIN:
      for (const OGRPolygon* face : *linear->toPolyhedralSurface()) {
        found.add_polygon(rings_of(*face));
      }
      break;
    case wkbMultiPoint:
    case wkbMultiLineString:
    case wkbMultiPolygon:
    case wkbGeometryCollection:
      for (const OGRGeometry* part : *linear->toGeometryCollection()) {
        collect_geometry(*part, found);
      }
      break;
    case wkbPoint:
      found.others.add(kinds::kPoint);
      break;
    default:
      found.others.add({linear->getGeometryName(), linear->getGeometryName()});
  }
}

}  // namespace ridgeline::io
