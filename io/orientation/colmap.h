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
  std::string name;          ///< path below the model's image folder
  std::uint32_t camera = 0;  ///< id of the camera
  InteriorOrientation interior;
  ExteriorOrientation exterior;
};

/// The images of the COLMAP model in `folder`, by id: cameras and images as .bin or .txt (.bin wins
/// if both are there). Models PINHOLE, SIMPLE_PINHOLE, SIMPLE_RADIAL, RADIAL and OPENCV. COLMAP's
/// (0.5, 0.5) is the centre of the top-left pixel; the result has (0, 0) there.
/// Throws IoError for a missing or damaged file, another camera model, or an image without camera.
std::vector<ColmapImage> read_colmap(const std::string& folder);

}  // namespace ridgeline::io
