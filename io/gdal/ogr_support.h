// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Keeps GDAL from printing while it lives and collects GDAL's complaints. GDAL's handlers are a
/// stack per thread, so an object must end in the thread and block that it began in.
class QuietGdal {
 public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;

  /// All complaints so far in one line of 200 characters at most; `fallback` if there are none.
  [[nodiscard]] std::string complaints(const std::string& fallback) const;

 private:
  std::vector<std::string> complaints_;
};

/// Registers GDAL's drivers, once in the process: GDALAllRegister() must not run in two threads.
void register_gdal_drivers();

/// Fixes the date that a GeoPackage stores as its time of writing, so that equal sets give equal
/// files. The option holds for this thread only.
class FixedDate {
 public:
  static constexpr const char* kText = "2000-01-01T00:00:00.000Z";
  FixedDate();
  ~FixedDate();
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
};

/// The reference system for GDAL, with axes east, north, up. Nothing if the definition is empty or
/// PROJ cannot read it.
std::optional<OGRSpatialReference> spatial_reference(const Crs& crs);

/// Makes a layer by GDALDataset::CreateLayer(). GDAL complains of a projected system with three
/// axes, which has no WKT1, and then writes WKT2 (GeoPackage); this complaint is forgotten if there
/// is a layer. A Shapefile has WKT1 alone and gets the system of the plan.
OGRLayer* create_layer(GDALDataset& dataset,
                       const std::string& name,
                       const OGRSpatialReference* reference,
                       OGRwkbGeometryType type,
                       CSLConstList options);

/// The name of the system of a file whose data state none: a plane with metres that is nowhere on
/// Earth.
inline constexpr const char* kUndefinedPlane = "Undefined Cartesian SRS";
OGRSpatialReference undefined_plane();

/// The system as WKT2; unknown for null and for the undefined systems of GeoPackage.
Crs crs_of(const OGRSpatialReference* reference);

}  // namespace ridgeline::io
