// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/image_turn.h"

#include <gdal_priv.h>

#include <string>

namespace ridgeline::io {

/// The turn that an open image file states: of JPEG by EXIF, of TIFF by the tag Orientation of its
/// first directory, which GDAL does not hand over. kNone for other formats, and where the tag is
/// absent or has no known value.
ImageTurn stated_turn(const std::string& path, GDALDataset& dataset);

}  // namespace ridgeline::io
