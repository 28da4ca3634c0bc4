// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/face.h"
#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline {

/// A straight piece of the borders of faces, along which the same faces meet.
struct FaceSeam {
  Segment3 segment;
  std::vector<std::size_t> faces;  ///< numbers of the faces, ascending
};

/// All edges of faces, each once, as long as its faces stay the same. Vertices within 1 cm are one.
/// Faces meet where their edges run along each other, also if a vertex of one lies within an edge
/// of another. An edge that one face has twice, as the bridge to a hole in a ring, is none of that
/// face. Edges that are not finite are left out. In the order in which the faces have them.
std::vector<FaceSeam> seams_of(std::span<const Face> faces);

}  // namespace ridgeline
