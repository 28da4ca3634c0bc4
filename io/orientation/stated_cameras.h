// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/read_orientation.h"

#include <string>
#include <vector>

namespace ridgeline::io {

/// Adds the cameras of options.cameras to an orientation whose file has none and assigns them to
/// the images. `names`: the camera name of each image, as stated in its file. If the camera file
/// has a single camera, all images get it, whatever name they use. Without options.cameras the
/// images have no camera. Throws IoError for a camera file that cannot be read or lacks a camera
/// that an image names.
void add_stated_cameras(const std::string& path,
                        const OrientationOptions& options,
                        const std::vector<std::string>& names,
                        Orientation& orientation);

}  // namespace ridgeline::io
