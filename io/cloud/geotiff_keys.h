// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A CRS as stated by GeoTIFF keys.
struct GeoTiffCrs {
  /// "EPSG:horizontal" or "EPSG:horizontal+vertical", WKT if the heights have a different unit;
  /// unknown if the keys name no CRS
  Crs crs;
  std::optional<double> horizontal_unit_m;  ///< stated by key 3076
  /// The unit stated by key 4099; without that key, the unit of the system of key 4096 if no
  /// horizontal system is known.
  std::optional<double> vertical_unit_m;
  std::vector<std::string> warnings;
};

/// Reads the GeoTIFF key directory of LAS record 34735: EPSG codes of the projected (3072),
/// geographic (2048) and vertical (4096) CRS and the units. A damaged directory or a user-defined
/// system yields an unknown CRS with a warning: nothing is guessed from parameters.
/// Source: OGC GeoTIFF 1.1 (19-008r4), section 7.
GeoTiffCrs parse_geotiff_keys(std::span<const std::byte> directory);

}  // namespace ridgeline::io
