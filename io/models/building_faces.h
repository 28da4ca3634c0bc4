// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"
#include "io/models/gml_surfaces.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::io {

/// A property that holds a geometry, <lod2Solid> for example.
struct GeometryProperty {
  int lod = 0;
  FaceKind kind = FaceKind::kUnknown;
  std::string surface_id;  ///< gml:id of the RoofSurface, WallSurface, ... that it is of
  bool is_thematic =
      false;  ///< it is of a RoofSurface, WallSurface, ..., not of the building itself
  bool is_extra =
      false;  ///< it is of an installation or an opening, which do not decide the level of detail
  std::size_t part = 0;  ///< counts the building, its parts and installations
  SurfaceRange surfaces;
};

/// A reference that names nothing in its building.
struct OpenReference {
  std::string id;
  std::size_t building = 0;
  FaceKind kind = FaceKind::kUnknown;
};

/// Appends the faces of the last building of a model, and gives the building its level of detail.
/// Each polygon becomes one face at most: thematic surfaces come first, and solids add what these
/// do not hold. A polygon of a solid that repeats the outline of a face of the same part is left
/// out. `open` takes references to what is not in the building.
void append_faces(const GmlSurfaces& surfaces,
                  const std::vector<GeometryProperty>& properties,
                  const ReadModelOptions& options,
                  BuildingModel& model,
                  std::vector<OpenReference>& open);

/// Copies the faces of other buildings that `open` names, after all buildings were read, and counts
/// the references that name nothing.
void resolve(const std::vector<OpenReference>& open, BuildingModel& model);

}  // namespace ridgeline::io
