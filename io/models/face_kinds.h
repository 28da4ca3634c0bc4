// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <span>

namespace ridgeline::io {

/// Gives the faces of a building that are unknown a kind by geometry, see settle(). All must have a
/// plane.
void state_kinds(std::span<ModelFace> faces);

}  // namespace ridgeline::io
