// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/orientation.h"

#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::simulate {

/// Files of a written orientation, as names relative to its folder.
struct OrientationFiles {
  std::string orientation;  ///< input of read_orientation(); for COLMAP a folder
  std::string cameras;      ///< OrientationOptions::cameras; empty if the format states cameras
  std::string matrix;       ///< the word for OrientationOptions::matrix; empty if not needed
  std::vector<std::string> files;  ///< all files
};

/// The files of a format: opk, opensfm, pix4d, inpho, pat_b, blocks_exchange, metashape or colmap.
/// For any other name, throws std::invalid_argument with the most similar one.
OrientationFiles orientation_files(std::string_view format);

/// Writes an orientation, each file completely or not at all, such that read_orientation() recovers
/// its cameras and poses to double precision. For OpenSfM and Metashape, poses are converted to the
/// Earth-fixed coordinates that convert_to_map() expects. Throws IoError if a file cannot be
/// written, and std::invalid_argument for an unknown format, no images, an image without a camera,
/// a camera without size, with distortion or with two focal lengths, a name with characters other
/// than letters, digits, '.', '_' and '-', a system that the format cannot express, and for PAT-B
/// if there are several cameras that are not named after their images.
void write_orientation(const std::string& folder,
                       std::string_view format,
                       const io::Orientation& orientation);

}  // namespace ridgeline::simulate
