// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace ridgeline::io {

constexpr int kTiffCompression = 259;
constexpr int kTiffOrientation = 274;
constexpr int kTiffRowsPerStrip = 278;

/// The integer value (SHORT, LONG, LONG8) of a tag in the first directory of a TIFF or BigTIFF;
/// GDAL does not expose it. std::nullopt if the tag is absent or the file is truncated.
std::optional<std::uint64_t> tiff_tag(const std::string& path, int tag);

}  // namespace ridgeline::io
