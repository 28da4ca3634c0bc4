// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/ogr_support.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>

#include <algorithm>
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

}  // namespace

FixedDate::FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", kText); }
FixedDate::~FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }

void register_gdal_drivers() {
  static std::once_flag registered;
  // Each block of an image is needed only once; the default cache size is a share of the machine's
  // memory.
  constexpr GIntBig kCacheBytes = GIntBig{64} << 20U;
  std::call_once(registered, [] {
    GDALAllRegister();
    GDALSetCacheMax64(kCacheBytes);
  });
}

QuietGdal::QuietGdal() { CPLPushErrorHandlerEx(collect, &complaints_); }
QuietGdal::~QuietGdal() { CPLPopErrorHandler(); }

std::string QuietGdal::complaints(const std::string& fallback) const {
  constexpr std::size_t kMaxCharacters = 200;  // GDAL quotes whole definitions
  std::string all;
  for (const std::string& complaint : complaints_) all += (all.empty() ? "" : "; ") + complaint;
  if (all.size() > kMaxCharacters) all = all.substr(0, kMaxCharacters) + " ...";
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
  // GeoPackage defines two undefined systems, and GDAL writes the geographic one whatever the
  // coordinates are.
  const char* const name = reference->GetName();
  if (name != nullptr && std::string_view(name).starts_with("Undefined ")) return {};
  const QuietGdal quiet;
  const char* options[] = {"FORMAT=WKT2_2019", nullptr};
  char* text = nullptr;
  const OGRErr error = reference->exportToWkt(&text, options);
  const std::unique_ptr<char, decltype(&VSIFree)> owner(text, VSIFree);
  return error == OGRERR_NONE ? Crs{text} : Crs{};
}

}  // namespace ridgeline::io
