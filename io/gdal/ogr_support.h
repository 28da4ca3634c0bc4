// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Keeps GDAL from printing while it lives and collects what it complains of. GDAL's handlers are a
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

/// A GeoPackage stores when it was written; a fixed date makes equal sets equal files. The option
/// holds for this thread only.
class FixedDate {
 public:
  static constexpr const char* kText = "2000-01-01T00:00:00.000Z";
  FixedDate();
  ~FixedDate();
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
};

/// Nothing if PROJ cannot read the definition or it is empty. Axes are east, north, up.
std::optional<OGRSpatialReference> spatial_reference(const Crs& crs);

/// GDALDataset::CreateLayer(). GDAL complains of a projected system with three axes, which has no WKT1, and
/// then writes WKT2 (GeoPackage): what it said is forgotten if there is a layer. A Shapefile has WKT1 alone and
/// gets the system of the plan.
OGRLayer* create_layer(GDALDataset& dataset,
                       const std::string& name,
                       const OGRSpatialReference* reference,
                       OGRwkbGeometryType type,
                       CSLConstList options);

/// The system of a file for what states none: a plane with metres that is nowhere on Earth.
inline constexpr const char* kUndefinedPlane = "Undefined Cartesian SRS";
OGRSpatialReference undefined_plane();

/// As WKT2; unknown for null and for the undefined ones of GeoPackage.
Crs crs_of(const OGRSpatialReference* reference);

}  // namespace ridgeline::io
