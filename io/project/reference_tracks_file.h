// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A visible run of a true edge in one of several images, pixels of the file.
struct ReferenceSighting {
  std::size_t view = 0;  ///< place of the image in the list
  Segment2 segment;
};

/// A true edge with what the images show of it, all in the same direction of travel.
struct ReferenceTrack {
  std::string edge, kind;
  std::vector<ReferenceSighting> sightings;  ///< in the order of the file
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
