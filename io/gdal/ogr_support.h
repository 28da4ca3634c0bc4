// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Keeps GDAL from printing while the object exists and collects GDAL's messages. GDAL keeps a
/// stack of handlers per thread, so an object must be destroyed in the thread and block that
/// created it.
class QuietGdal {
 public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;

  /// All messages so far in one line of at most 200 characters; `fallback` if there are none.
  [[nodiscard]] std::string complaints(const std::string& fallback) const;

 private:
  std::vector<std::string> complaints_;
};

/// Registers GDAL's drivers once per process: GDALAllRegister() must not run in two threads.
void register_gdal_drivers();

/// Fixes the date that a GeoPackage stores as its time of writing, so that equal data give equal
/// files. The option holds for this thread only.
class FixedDate {
 public:
  static constexpr const char* kText = "2000-01-01T00:00:00.000Z";
  FixedDate();
  ~FixedDate();
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
};

/// The reference system for GDAL, with axes east, north, up. std::nullopt if the definition is
/// empty or PROJ cannot read it.
std::optional<OGRSpatialReference> spatial_reference(const Crs& crs);

/// Creates a layer with GDALDataset::CreateLayer(). A projected system with three axes cannot be
/// expressed as WKT1: GDAL reports an error, but then writes WKT2 (GeoPackage), so the error is
/// discarded if a layer was created. A Shapefile supports WKT1 only and gets the horizontal system.
OGRLayer* create_layer(GDALDataset& dataset,
                       const std::string& name,
                       const OGRSpatialReference* reference,
                       OGRwkbGeometryType type,
                       CSLConstList options);

/// The name of the system written to a file whose data have no CRS: a plane in metres without a
/// location on Earth.
inline constexpr const char* kUndefinedPlane = "Undefined Cartesian SRS";
OGRSpatialReference undefined_plane();

/// The system as WKT2; unknown for null and for GeoPackage's undefined systems.
Crs crs_of(const OGRSpatialReference* reference);

}  // namespace ridgeline::io
