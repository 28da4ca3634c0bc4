// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A block file with `lines`: files of lines that are judged against many tiles of LIDAR, in tasks
/// by area. Paths are those of the file, relative to its folder, with that folder in front.
struct LinesBlockFile {
  std::string path;
  std::string block;  ///< what the tables call it; empty: the name of the cloud
  std::vector<std::string> lines;
  std::vector<std::string> lidar;  ///< files and patterns
  Crs crs;  ///< of all inputs, whatever they state; unknown: as they state it
  std::optional<std::string> reference_lines;
  double patch_size_m = 500.0;                    ///< side of a cell
  std::optional<std::set<std::uint8_t>> classes;  ///< to keep; unset: all but noise
  bool exclude_withheld = true;
  bool last_returns = false;
  bool scale_to_ground = false;
  std::vector<double> bounds;  ///< x_min, y_min, x_max, y_max of the points to keep; may be empty
  std::vector<double> origin;  ///< of the local frame, whole metres; may be empty
};

/// Reads a block file with `lines`. Throws IoError with path, line and rule for a key that is
/// unknown or missing and for a value that is not possible.
LinesBlockFile read_lines_block(const std::string& path);

/// Whether a block file has lines to be judged, and not frames. Throws IoError for a file that
/// cannot be read.
bool is_lines_block(const std::string& path);

}  // namespace ridgeline::io
