// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::io {

/// The names that an OBJ gives to faces: those of the last `o`, `g` and `usemtl` records before
/// them. Each may be several words.
struct FaceNames {
  std::string object, group, material;
};

/// The names of the faces of a mesh.
struct MeshNames {
  std::vector<FaceNames> all;
  std::vector<std::size_t> of_face;  ///< index into `all` of each face; empty without names
};

/// Assigns the faces of a mesh to buildings, and gives them the kinds in their names if all faces
/// have one.
///
/// A word of a group, or else of an object, names a building if its faces include walls and others
/// and it is not a kind of surface ("RoofSurface", "wall", "Dach"). A building is a connected part
/// of the faces with the same name, together with the parts of this name that it meets or covers in
/// plan; parts that stand apart are separate buildings with the same id. Faces that no building is
/// named for belong to the only building that they are connected to. Otherwise each connected part
/// of them is a building, called by their common name, or "1", "2", ...
void divide_into_buildings(const MeshNames& names, BuildingModel& model);

}  // namespace ridgeline::io
