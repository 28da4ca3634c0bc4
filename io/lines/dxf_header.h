// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Information that a DXF states before its entities but that GDAL does not report.
struct DxfHeader {
  std::string unit;  ///< unit from $INSUNITS, "millimetres"; empty for metres and if none is stated
  std::set<std::string> hidden_layers;  ///< frozen or off; in lower case, UTF-8
};

/// Reads the header of a DXF. The result is empty for text that is not DXF and for binary DXF.
DxfHeader dxf_header(std::string_view content);

}  // namespace ridgeline::io
