// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/image_turn.h"

#include <gdal_priv.h>

#include <string>

namespace ridgeline::io {

/// The turn stated by an open image file: from EXIF in a JPEG, from the Orientation tag of the
/// first directory in a TIFF, which GDAL does not expose. kNone for other formats, and if the tag
/// is absent or has an unknown value.
ImageTurn stated_turn(const std::string& path, GDALDataset& dataset);

}  // namespace ridgeline::io
