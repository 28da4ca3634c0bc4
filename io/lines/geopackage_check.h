// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ridgeline::io {

/// Refuses a GeoPackage whose layers are programs rather than data, before GDAL opens it: views,
/// virtual tables and generated columns compute their rows, without end or of any size, when they
/// are read. A file below 16 MiB is scanned for values larger than itself, too.
/// Throws IoError naming the layer. A file that SQLite cannot read is left to GDAL to name.
void refuse_computed_layers(const std::string& path);

}  // namespace ridgeline::io
