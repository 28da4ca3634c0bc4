// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/face.h"

#include <span>

namespace ridgeline {

/// Gives each face of a building that has no known kind a kind from its geometry; see settle(). All
/// faces must have a plane.
void state_kinds(std::span<Face> faces);

}  // namespace ridgeline
