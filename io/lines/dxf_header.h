// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// What a DXF states before its entities but GDAL does not tell.
struct DxfHeader {
  std::string unit;  ///< unit by $INSUNITS, "millimetres"; empty for metres and if none is stated
  std::set<std::string> hidden_layers;  ///< frozen or off; in lower case, UTF-8
};

/// Reads the header of a DXF. Text that is no DXF, or a binary DXF, states nothing.
DxfHeader dxf_header(std::string_view content);

}  // namespace ridgeline::io
