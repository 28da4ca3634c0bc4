// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/info/info_warnings.h"
#include "io/kinds/file_kind.h"

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
void print_orientation(const std::string& path,
                       const OrientationArguments& arguments,
                       InfoWarnings& warnings);

/// Prints the orientation in a folder, or a list of them if there are several. Images are searched
/// in the folder and in its subfolder `images`. Throws IoError like print_orientation().
void print_orientations(const std::string& folder,
                        const io::FileKind& kind,
                        OrientationArguments arguments,
                        InfoWarnings& warnings);

}  // namespace ridgeline::apps
