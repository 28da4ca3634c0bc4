// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace ridgeline::io {

/// Whether a text begins with a WKT geometry name or with "SRID=...;" (EWKT), ignoring case.
bool begins_as_wkt(std::string_view text);

/// Converts variants written by other programs to OGC's WKT, "LINESTRING Z (": "LineStringZ (",
/// "LINESTRINGZ(", "linestring zm(".
std::string standard_wkt(std::string_view text);

}  // namespace ridgeline::io
