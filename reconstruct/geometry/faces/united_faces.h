// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/face.h"

#include <vector>

namespace ridgeline {

/// The faces of a building, of which those of one kind in one plane (up to half a degree) that meet
/// along an edge are one, at the place of the first, with its id and its sense of turn. Pieces
/// whose outline touches itself at a corner stay as they are. All must have a plane.
std::vector<Face> united_faces(std::vector<Face> faces);

}  // namespace ridgeline
