// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/read_orientation.h"

#include <string>
#include <vector>

namespace ridgeline::io {

/// Adds the cameras of options.cameras to an orientation whose file has none and assigns them to
/// the images. `names`: the camera of each image as its file states it. A file with a single camera
/// serves all images whatever they call it. Without options.cameras the images have no camera.
/// Throws IoError for a file of cameras that cannot be read or lacks one that an image names.
void add_stated_cameras(const std::string& path,
                        const OrientationOptions& options,
                        const std::vector<std::string>& names,
                        Orientation& orientation);

}  // namespace ridgeline::io
