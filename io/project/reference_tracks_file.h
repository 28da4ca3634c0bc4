// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/track.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A true edge with its visible runs in several images, which are identified by their positions in
/// a list. All runs have the same direction; coordinates are pixels of the files.
struct ReferenceTrack {
  std::string edge, kind;
  std::vector<ObservedSegment> observations;  ///< in the order of the file
};

/// Reads the file given by `reference_tracks`, `edge,image,x1_px,y1_px,x2_px,y2_px`; rows and
/// columns may be in any order, a column `kind` is optional, other columns are ignored. The edges
/// are in the order of their first rows.
/// @param images  ids of the views
/// @param passes_over_others  whether to skip rows of images that are not among `images`
/// Throws IoError naming the row for a missing column, a value that is not a number and, unless
/// these are skipped, an image that is not among `images`.
std::vector<ReferenceTrack> read_reference_tracks(const std::string& path,
                                                  std::span<const std::string> images,
                                                  bool passes_over_others = false);

}  // namespace ridgeline::io
