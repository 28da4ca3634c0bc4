// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"
#include "io/project/patch.h"

#include <string>

namespace ridgeline::io {

/// Converts an image of an orientation to an image of a patch. `path` is the image file, whose
/// top-left pixel is `window_px` in the frame; the id is the last part of the image's name without
/// its extension. Throws std::invalid_argument if the image has no camera.
PatchImage oriented_patch_image(const Orientation& orientation,
                                const OrientedImage& image,
                                const std::string& path,
                                const Eigen::Vector2d& window_px = Eigen::Vector2d::Zero());

}  // namespace ridgeline::io
