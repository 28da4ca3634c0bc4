// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/ogr_support.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <string_view>

namespace ridgeline::io {
namespace {

void CPL_STDCALL collect(CPLErr, CPLErrorNum, const char* message) {
  auto* complaints = static_cast<std::vector<std::string>*>(CPLGetErrorHandlerUserData());
  std::string line(message);
  std::replace(line.begin(), line.end(), '\n', ' ');
  complaints->push_back(std::move(line));
}

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
  std::vector<Vertices> rings;
  for (const OGRLinearRing* ring : polygon) rings.push_back(vertices_of(*ring));
  return rings;
}

}  // namespace

FixedDate::FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", kText); }
FixedDate::~FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }

void register_gdal_drivers() {
  static std::once_flag registered;
  std::call_once(registered, [] { GDALAllRegister(); });
}

QuietGdal::QuietGdal() { CPLPushErrorHandlerEx(collect, &complaints_); }
QuietGdal::~QuietGdal() { CPLPopErrorHandler(); }

std::string QuietGdal::complaints(const std::string& fallback) const {
  constexpr std::size_t kMostCharacters = 200;  // of GDAL, which quotes whole definitions
  std::string all;
  for (const std::string& complaint : complaints_) all += (all.empty() ? "" : "; ") + complaint;
  if (all.size() > kMostCharacters) all = all.substr(0, kMostCharacters) + " ...";
  return all.empty() ? fallback : all;
}

std::optional<OGRSpatialReference> spatial_reference(const Crs& crs) {
  if (!crs.known()) return std::nullopt;
  const QuietGdal quiet;
  OGRSpatialReference reference;
  // The definition comes from a data file: it must not make PROJ or GDAL open files or addresses.
  if (reference.SetFromUserInput(crs.definition.c_str(),
                                 OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) !=
      OGRERR_NONE) {
    return std::nullopt;
  }
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

OGRLayer* create_layer(GDALDataset& dataset,
                       const std::string& name,
                       const OGRSpatialReference* reference,
                       OGRwkbGeometryType type,
                       CSLConstList options) {
  std::optional<OGRSpatialReference> written;
  if (reference != nullptr) {
    written = *reference;
    const bool has_three_axes =
        written->IsProjected() != 0 && written->IsCompound() == 0 && written->GetAxesCount() == 3;
    if (has_three_axes && EQUAL(dataset.GetDriverName(), "ESRI Shapefile")) {
      written->DemoteTo2D(nullptr);
    }
  }
  OGRLayer* const layer =
      dataset.CreateLayer(name.c_str(), written ? &*written : nullptr, type,
                          const_cast<char**>(options));  // NOLINT: GDAL reads them only
  if (layer != nullptr) CPLErrorReset();
  return layer;
}

OGRSpatialReference undefined_plane() {
  OGRSpatialReference reference;
  reference.SetLocalCS(kUndefinedPlane);
  reference.SetLinearUnits("metre", 1.0);
  return reference;
}

Crs crs_of(const OGRSpatialReference* reference) {
  if (reference == nullptr) return {};
  // GeoPackage has names for none, and GDAL writes the geographic one whatever the coordinates are
  const char* const name = reference->GetName();
  if (name != nullptr && std::string_view(name).starts_with("Undefined ")) return {};
  const QuietGdal quiet;
  const char* options[] = {"FORMAT=WKT2_2019", nullptr};
  char* text = nullptr;
  const OGRErr error = reference->exportToWkt(&text, options);
  const std::unique_ptr<char, decltype(&VSIFree)> owner(text, VSIFree);
  return error == OGRERR_NONE ? Crs{text} : Crs{};
}

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
