// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace ridgeline::io {

/// The end of a message on a file of another kind.
inline constexpr const char* kWhatIsRead =
    "lines are read from GeoJSON, GeoPackage, Shapefile, DXF, CSV, WKT, OBJ and PLY";

/// Throws IoError that names what a file is, by its first bytes, where that is a kind without lines that are read, or one whose
/// name ends otherwise: a cloud, a picture, an archive, XML, a drawing, text that is no UTF-8.
void refuse_other_kind(const std::string& path, std::string_view content);

/// What files with such an extension hold, ".gml"; empty if that is not known.
std::string kind_by_extension(std::string_view extension);

}  // namespace ridgeline::io
