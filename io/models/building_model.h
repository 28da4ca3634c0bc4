// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"
#include "io/gdal/attribute_table.h"
#include "io/text/kind_counts.h"
#include "reconstruct/geometry/faces/face.h"

#include <string>
#include <vector>

namespace ridgeline::io {

/// A building with all of its parts.
struct Building {
  std::string id;
  std::string lod;  ///< of its faces, as the file says: "2.2", "2"; empty if it does not
};

/// The buildings of a file by their faces.
struct BuildingModel {
  std::string path;
  std::string format;  ///< "CityJSON 1.1", "CityGML 2.0", ...
  Crs crs;
  std::vector<Building> buildings;  ///< in the order of the file; those without faces stay
  /// In the order of the file and in its coordinates; Face::building is an index of `buildings`.
  std::vector<Face> faces;
  AttributeTable
      attributes;       ///< what the file states of its buildings; row i is that of buildings[i]
  KindCounts left_out;  ///< what the file holds beside faces of buildings, and faces that are none
  std::vector<std::string> warnings;
};

struct ReadModelOptions {
  /// The level of detail that is read: "2.2", or "2" for the highest one of 2.x. If empty, each
  /// building has the highest one that it is given in, up to 3.x.
  std::string lod;
};

}  // namespace ridgeline::io
