// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::simulate {

/// Files of a written orientation, by their names in the folder that it is written to.
struct OrientationFiles {
  std::string orientation;  ///< what read_orientation() takes; of COLMAP a folder
  std::string cameras;      ///< OrientationOptions::cameras; empty if the format states cameras
  std::string matrix;       ///< the word for OrientationOptions::matrix; empty if none is needed
  std::vector<std::string> files;  ///< all files
};

/// The files of a format: opk, opensfm, pix4d, inpho, pat_b, blocks_exchange, metashape or colmap.
/// Throws std::invalid_argument for another name and names the nearest.
OrientationFiles orientation_files(std::string_view format);

/// Writes an orientation, each file whole or not at all, so that read_orientation() gives back its
/// cameras and poses to the digits of a double. OpenSfM and Metashape get poses that lie on the
/// Earth, as convert_to_map() takes them. Throws IoError if a file cannot be written, and
/// std::invalid_argument for an unknown format, no images, an image without camera, a camera
/// without size, with distortion or with two focal lengths, a name that is not made of letters,
/// digits, '.', '_' and '-', a system that the format cannot state, and for PAT-B if there are
/// several cameras that are not named after their images.
void write_orientation(const std::string& folder,
                       std::string_view format,
                       const io::Orientation& orientation);

}  // namespace ridgeline::simulate
