// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ridgeline::io {

/// A layer of a GeoPackage that cannot be read.
struct UnreadLayer {
  std::string name;
  std::string why;  ///< "is listed, but has no table"
};

/// The layers that must not be read, as they are programs rather than data: views, virtual tables and tables with generated
/// columns compute their rows, without end or of any size, when they are read. And those that are listed, but have no table.
/// To be asked before GDAL opens the file. The other layers of a file below 16 MiB are scanned for values larger than the
/// file. A file that SQLite cannot read is left to GDAL to name.
/// Throws IoError if the tables of GeoPackage itself are computed, and naming the layer for a damaged one.
std::vector<UnreadLayer> unread_layers(const std::string& path);

}  // namespace ridgeline::io
