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

/// All edges of the faces, each once; a seam extends as far as its faces stay the same. Vertices
/// within 1 cm of each other are treated as one. Faces meet where their edges coincide, even if a
/// vertex of one lies within an edge of another. An edge that a face has twice, such as the bridge
/// to a hole in a ring, is not an edge of that face. Edges that are not finite are left out. The
/// seams are in the order in which the faces have them.
std::vector<FaceSeam> seams_of(std::span<const Face> faces);

}  // namespace ridgeline
