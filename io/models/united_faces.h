// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <vector>

namespace ridgeline::io {

/// The faces of a building, of which those of one kind in one plane (up to half a degree) that meet
/// along an edge are one, at the place of the first, with its id and its sense of turn. Pieces
/// whose outline touches itself at a corner stay as they are. All must have a plane.
std::vector<ModelFace> united_faces(std::vector<ModelFace> faces);

}  // namespace ridgeline::io
