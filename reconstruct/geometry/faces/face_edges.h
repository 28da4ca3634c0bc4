// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/face.h"
#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline {

/// An edge of roof faces.
struct FaceEdge {
  Segment3 segment;
  std::string kind;                ///< "ridge", "hip", "valley", "eave", "verge" or "step"
  std::vector<std::size_t> roofs;  ///< numbers of its roof faces, ascending
};

struct FaceEdges {
  std::vector<FaceEdge> edges;
  std::size_t n_crowded = 0;  ///< edges shared by three or more roof faces; they are left out
};

/// The edges of the roofs of a building, each once:
///   ridge   two roof faces fall away from it, and it is level (up to 5 degrees)
///   hip     two roof faces fall away from it, and it is inclined
///   valley  two roof faces rise from it
///   eave    border of an inclined roof face across its slope (more than 45 degrees from the slope
///           in plan)
///   verge   border of an inclined roof face along its slope (up to 45 degrees from the slope in
///           plan)
///   step    border of a level roof face (up to 5 degrees), or the foot of a wall that rises from a
///           roof face
/// Two roof faces within 5 degrees of each other have no common edge. An edge ends where its faces
/// change; see seams_of(). All faces must have a plane and a kind.
FaceEdges edges_of_roofs(std::span<const Face> faces);

}  // namespace ridgeline
