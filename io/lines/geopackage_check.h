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

/// Returns the layers that must not be read. Views, virtual tables and tables with generated
/// columns are programs rather than data: they compute their rows when they are read, possibly
/// without end or of any size. Layers that are listed but have no table are included. Must be
/// called before GDAL opens the file. The other layers of a file of up to 16 MiB are scanned for
/// values larger than the file. A file that SQLite cannot read is left for GDAL to report. Throws
/// IoError if the tables of GeoPackage itself are computed or if a layer, which is named, is
/// damaged.
std::vector<UnreadLayer> unread_layers(const std::string& path);

}  // namespace ridgeline::io
