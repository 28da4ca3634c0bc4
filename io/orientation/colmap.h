// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/orientation.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::io {

/// One registered image of a COLMAP model.
struct ColmapImage {
  std::uint32_t id = 0;
  std::string name;          ///< path relative to the model's image folder
  std::uint32_t camera = 0;  ///< id of the camera
  InteriorOrientation interior;
  ExteriorOrientation exterior;
};

/// The images of the COLMAP model in `folder`, by id: cameras and images as .bin or .txt (.bin is
/// preferred). Supported models: PINHOLE, SIMPLE_PINHOLE, SIMPLE_RADIAL, RADIAL and OPENCV. In
/// COLMAP the centre of the top-left pixel is (0.5, 0.5); in the result it is (0, 0).
/// Throws IoError for a missing or damaged file, another camera model, or an image without a
/// camera.
std::vector<ColmapImage> read_colmap(const std::string& folder);

/// The files of a COLMAP model that read_colmap() may read.
std::vector<std::string> colmap_files(const std::string& folder);

}  // namespace ridgeline::io
