// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "reconstruct/geometry/orientation.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A camera from an orientation file. Its pixel (0, 0) is the centre of the top-left pixel,
/// whatever the file's convention.
struct Camera {
  std::string name;
  InteriorOrientation interior;
};

struct OrientedImage {
  std::string name;  ///< as stated in the file, often without folder or extension; unique in a file
  std::optional<std::size_t>
      camera;  ///< index in Orientation::cameras; unset if no file states the camera
  ExteriorOrientation exterior;  ///< in the orientation's reference system
};

/// The result of an aerotriangulation: cameras and image poses.
struct Orientation {
  std::string format;  ///< "OpenSfM reconstruction"
  std::vector<Camera> cameras;
  std::vector<OrientedImage> images;
  Crs crs;
  std::vector<std::string> files_beside;  ///< other files that were read with the orientation
  std::optional<double> ground_height_m;  ///< mean height of the ground, if the file states it
  std::vector<std::string>
      decisions;  ///< ambiguities of the file and how they were resolved, as sentences
  std::vector<std::string> warnings;
};

/// The last part of an image's name: "1.tif" for "D:\\flight\\1.tif".
std::string file_name_of(const OrientedImage& image);

}  // namespace ridgeline::io
