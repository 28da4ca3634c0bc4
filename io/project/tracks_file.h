// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/track.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Writes `track,image,segment`, one row per observation in the order of the tracks and of their
/// observations. A track's number counts from 0, a segment's is its index in the image's segment
/// file.
/// @param images  ids of the views
/// Whole or not at all. Throws IoError.
void write_tracks(const std::string& path,
                  std::span<const Track> tracks,
                  std::span<const std::string> images);

/// Reads what write_tracks() writes; rows and columns in any order, other columns are passed over.
/// Throws IoError naming the row for a missing column, a number that is no index, an image that is
/// not among `images` and a track that does not begin with two images.
std::vector<Track> read_tracks(const std::string& path, std::span<const std::string> images);

}  // namespace ridgeline::io
