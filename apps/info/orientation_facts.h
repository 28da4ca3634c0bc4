// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace ridgeline::apps {

/// The options for an orientation on the command line.
struct OrientationArguments {
  std::string cameras;   ///< camera file
  std::string images;    ///< image folder; empty: that of the orientation
  std::string angles;    ///< deg | gon | rad
  std::string rotation;  ///< opk | pok
  std::string matrix;    ///< world_from_camera | camera_from_world
  std::string crs;
  std::string map;  ///< GeoPackage to write
  std::optional<double> ground_height_m;
};

/// Prints the content of an orientation and the decisions made in reading it, and writes the map if
/// requested. Throws IoError like io::read_orientation(), and if the map requires a ground height.
void print_orientation(const std::string& path, const OrientationArguments& arguments);

}  // namespace ridgeline::apps
