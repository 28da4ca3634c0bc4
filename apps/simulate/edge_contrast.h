// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/image_window.h"
#include "reconstruct/geometry/segment.h"

namespace ridgeline::simulate {

/// Mean difference between the two sides of a segment in the band where it is largest, as a share
/// of the image's range. `segment_px`: in pixels of the image; the window must contain it with two
/// pixels on each side.
double contrast_across(const ImageWindow& window, const Segment2& segment_px);

}  // namespace ridgeline::simulate
