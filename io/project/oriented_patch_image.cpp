// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/oriented_patch_image.h"

#include "reconstruct/geometry/check.h"

#include <filesystem>

namespace ridgeline::io {

PatchImage oriented_patch_image(const Orientation& orientation,
                                const OrientedImage& image,
                                const std::string& path,
                                const Eigen::Vector2d& window_px) {
  check(image.camera.has_value(), "image ", image.name, ", must have a camera");
  const InteriorOrientation& interior = orientation.cameras[*image.camera].interior;
  PatchImage made;
  made.id = std::filesystem::path(file_name_of(image)).stem().string();
  made.path = path;
  made.window_px = window_px;
  made.image_from_world = window_from_world(projection_matrix(interior, image.exterior), window_px);
  made.interior = interior;
  made.exterior = image.exterior;
  return made;
}

}  // namespace ridgeline::io
