// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace ridgeline::io {

/// Whether a text begins with the name of a geometry as WKT has it, or with "SRID=...;" (EWKT); in
/// any case.
bool begins_as_wkt(std::string_view text);

/// WKT as OGC has it, "LINESTRING Z (", from what other programs write: "LineStringZ (",
/// "LINESTRINGZ(", "linestring zm(".
std::string standard_wkt(std::string_view text);

}  // namespace ridgeline::io
