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

/// A camera as an orientation file states it. Its pixel (0, 0) is the centre of the top-left pixel,
/// whatever the file counts from.
struct Camera {
  std::string name;
  InteriorOrientation interior;
};

struct OrientedImage {
  std::string
      name;  ///< as the file states it, often without folder or extension; never twice in a file
  std::optional<std::size_t>
      camera;  ///< number in Orientation::cameras; none if no file states the camera
  ExteriorOrientation exterior;  ///< in the orientation's reference system
};

/// What an aerotriangulation found: the cameras and where the images were taken.
struct Orientation {
  std::string format;  ///< "OpenSfM reconstruction"
  std::vector<Camera> cameras;
  std::vector<OrientedImage> images;
  Crs crs;
  std::optional<double> ground_height_m;  ///< mean height of the ground, where the file states one
  std::vector<std::string>
      decisions;  ///< what the file leaves open and how it was decided, whole sentences
  std::vector<std::string> warnings;
};

/// The last part of the name of an image: "D:\\flight\\1.tif" gives "1.tif".
std::string file_name_of(const OrientedImage& image);

}  // namespace ridgeline::io
