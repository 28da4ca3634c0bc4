// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace ridgeline::io {

constexpr int kTiffCompression = 259;
constexpr int kTiffOrientation = 274;
constexpr int kTiffRowsPerStrip = 278;

/// The whole number (SHORT, LONG, LONG8) that a tag of the first directory of a TIFF or BigTIFF
/// holds, which GDAL does not hand over. Nothing if the tag is absent or the file ends early.
std::optional<std::uint64_t> tiff_tag(const std::string& path, int tag);

}  // namespace ridgeline::io
