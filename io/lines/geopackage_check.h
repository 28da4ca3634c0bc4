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

/// The layers that must not be read. Views, virtual tables and tables with generated columns are
/// programs rather than data: they compute their rows, without end or of any size, when they are
/// read. Layers that are listed but have no table are among them, too. The function must be called
/// before GDAL opens the file. The other layers of a file of up to 16 MiB are scanned for values
/// larger than the file. A file that SQLite cannot read is left to GDAL to name. Throws IoError if
/// the tables of GeoPackage itself are computed, and naming the layer for a damaged one.
std::vector<UnreadLayer> unread_layers(const std::string& path);

}  // namespace ridgeline::io
