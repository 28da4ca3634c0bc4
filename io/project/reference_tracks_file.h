// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/track.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A true edge with its visible runs in several images, by the places of the images in a list. All
/// run in the same direction, in pixels of the files.
struct ReferenceTrack {
  std::string edge, kind;
  std::vector<ObservedSegment> observations;  ///< in the order of the file
};

/// Reads the file that `reference_tracks` names, `edge,image,x1_px,y1_px,x2_px,y2_px`; rows and
/// columns in any order, an optional column `kind`, other columns are passed over. The edges are in
/// the order of their first rows.
/// @param images  ids of the views
/// @param passes_over_others  whether rows of images that are not among `images` are passed over
/// Throws IoError naming the row for a missing column, a value that is no number and an image that
/// is not among `images`.
std::vector<ReferenceTrack> read_reference_tracks(const std::string& path,
                                                  std::span<const std::string> images,
                                                  bool passes_over_others = false);

}  // namespace ridgeline::io
