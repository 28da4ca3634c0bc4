// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <functional>
#include <span>

namespace ridgeline::io {

/// Brings a model into the form that edges and faces are taken from:
///   - faces of a building stand together, and each building has an id of its own ("_1", "_2", ...
///     behind it, with a warning)
///   - every face has an area and is finite; holes without one, and of faces with one outline all
///     but one, are left out. Counted.
///   - every face is a roof, a wall, the ground or another one. Where the file does not state it, a
///     face steeper than 80 degrees is a wall, and of the others one with another such face of its
///     building above it is the ground
///   - faces in one plane that meet along an edge are one face, as the triangles of a mesh
void settle(BuildingModel& model);

/// Calls `take` with the number of a building and its faces, which stand together; not for
/// buildings without faces.
void for_each_building(
    const BuildingModel& model,
    const std::function<void(std::size_t building, std::span<const Face> faces)>& take);

}  // namespace ridgeline::io
