// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/image.h"

#include <gdal_priv.h>

#include <optional>

namespace ridgeline::io {

/// The alpha band of an open image. GDAL declares the fourth band of an 8-bit TIFF as alpha unless
/// told otherwise, even if it is near infrared. Therefore, a band declared as alpha is one only if
/// nearly all values of a sample are 0 or the largest value. Nothing is decoded if no band is
/// declared as alpha.
std::optional<AlphaBand> alpha_band(GDALDataset& dataset);

}  // namespace ridgeline::io
