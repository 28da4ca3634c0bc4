// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/face.h"

#include <vector>

namespace ridgeline {

/// Unites the faces of a building that have the same kind and plane (to within half a degree) and
/// meet along an edge. The united face takes the position in the list, the id and the direction of
/// rotation of the first one. Pieces whose common outline touches itself at a corner stay as they
/// are. All faces must have a plane.
std::vector<Face> united_faces(std::vector<Face> faces);

}  // namespace ridgeline
