// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"
#include "io/models/gml_surfaces.h"
#include "io/models/lod.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A property that contains a geometry, for example <lod2Solid>.
struct GeometryProperty {
  int lod = 0;
  FaceKind kind = FaceKind::kUnknown;
  std::string surface_id;  ///< gml:id of the RoofSurface, WallSurface, ... that it belongs to
  bool is_thematic =
      false;  ///< belongs to a RoofSurface, WallSurface, ..., not to the building itself
  bool is_extra = false;  ///< belongs to an installation or an opening, which do not determine the
                          ///< level of detail
  std::size_t part = 0;   ///< index among the building, its parts and installations
  SurfaceRange surfaces;
};

/// A reference to something outside its building.
struct OpenReference {
  std::string id;
  std::size_t building = 0;
  FaceKind kind = FaceKind::kUnknown;
};

/// Appends the faces of the last building of a model and sets the building's level of detail, the
/// highest of its parts. `ids`: of the building, its parts and installations. An installation is
/// read in the level of its building. Each polygon becomes at most one face: thematic surfaces come
/// first, and solids add the polygons that these lack. A polygon of a solid that repeats the
/// outline of a face of the same part is left out. References to anything outside the building are
/// added to `open`.
void append_faces(const GmlSurfaces& surfaces,
                  const std::vector<GeometryProperty>& properties,
                  const std::vector<std::string>& ids,
                  LodChoice& choice_of_lods,
                  BuildingModel& model,
                  std::vector<OpenReference>& open);

/// Copies the faces of other buildings to which `open` refers, after all buildings have been read,
/// and counts the references without a target.
void resolve(const std::vector<OpenReference>& open, BuildingModel& model);

}  // namespace ridgeline::io
