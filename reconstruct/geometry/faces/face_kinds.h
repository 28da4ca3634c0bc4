// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/face.h"

#include <span>

namespace ridgeline {

/// Gives the faces of a building that are unknown a kind by geometry, see settle(). All must have a
/// plane.
void state_kinds(std::span<Face> faces);

}  // namespace ridgeline
