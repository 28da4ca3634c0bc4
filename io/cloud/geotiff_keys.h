// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A CRS as GeoTIFF keys give it.
struct GeoTiffCrs {
  /// "EPSG:horizontal" or "EPSG:horizontal+vertical", WKT if the heights have another unit; unknown
  /// if the keys name no CRS
  Crs crs;
  std::optional<double> horizontal_unit_m;  ///< stated by key 3076
  /// The unit that key 4099 states; without it, that of the system of key 4096 if no horizontal
  /// system is known.
  std::optional<double> vertical_unit_m;
  std::vector<std::string> warnings;
};

/// Reads the directory of GeoTIFF keys of LAS record 34735: EPSG codes of the projected (3072),
/// geographic (2048) and vertical (4096) CRS and the units. A damaged directory, or a user-defined
/// system, gives an unknown CRS with a warning: nothing is guessed from parameters.
/// Source: OGC GeoTIFF 1.1 (19-008r4), section 7.
GeoTiffCrs parse_geotiff_keys(std::span<const std::byte> directory);

}  // namespace ridgeline::io
