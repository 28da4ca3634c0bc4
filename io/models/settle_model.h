// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <functional>
#include <span>

namespace ridgeline::io {

/// Normalises a model so that edges and faces can be taken from it:
///   - the faces of a building are contiguous, and each building has a unique id ("_1", "_2", ...
///     are appended, with a warning)
///   - every face is finite and has an area. Faces without an area, and all but one of the faces of
///     a building with the same outline, are left out and counted; holes without an area are left
///     out
///   - every face is a roof, a wall, ground or other. If the file does not state the kind, a face
///     steeper than 80 degrees is a wall, and any other face is ground if another such face of its
///     building lies above it
///   - coplanar faces that meet along an edge are merged, like the triangles of a mesh
void settle(BuildingModel& model);

/// Calls `take` with the index of each building and its faces, which must be contiguous; buildings
/// without faces are skipped.
void for_each_building(
    const BuildingModel& model,
    const std::function<void(std::size_t building, std::span<const Face> faces)>& take);

}  // namespace ridgeline::io
