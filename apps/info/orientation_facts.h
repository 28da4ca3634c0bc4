// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace ridgeline::apps {

/// What a user says about an orientation on the command line.
struct OrientationArguments {
  std::string cameras;   ///< file of cameras
  std::string images;    ///< folder of the images; empty: that of the orientation
  std::string angles;    ///< deg | gon | rad
  std::string rotation;  ///< opk | pok
  std::string matrix;    ///< world_from_camera | camera_from_world
  std::string crs;
  std::string map;  ///< GeoPackage to write
  std::optional<double> ground_height_m;
};

/// Prints what an orientation holds and what was decided in reading it, and writes the map if one
/// is asked for. Throws IoError as io::read_orientation() does, and if the map needs a height of
/// the ground.
void print_orientation(const std::string& path, const OrientationArguments& arguments);

}  // namespace ridgeline::apps
