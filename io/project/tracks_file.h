// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/track.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Writes `track,image,segment`, one row per observation in the order of the tracks and of their
/// observations. Tracks are numbered from 0; a segment's number is its index in the image's segment
/// file.
/// @param images  ids of the views
/// The file is written completely or not at all. Throws IoError if it cannot be written.
void write_tracks(const std::string& path,
                  std::span<const Track> tracks,
                  std::span<const std::string> images);

/// Reads what write_tracks() writes; rows and columns may be in any order, other columns are
/// ignored. Throws IoError naming the row for a missing column, a number that is not an index, an
/// image that is not among `images` and a track that does not begin with two images.
std::vector<Track> read_tracks(const std::string& path, std::span<const std::string> images);

}  // namespace ridgeline::io
