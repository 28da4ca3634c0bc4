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
  std::string lod;  ///< level of detail of its faces in the file: "2.2", "2"; empty if not stated
};

/// The buildings of a file, represented by their faces.
struct BuildingModel {
  std::string path;
  std::string format;  ///< "CityJSON 1.1", "CityGML 2.0", ...
  Crs crs;
  std::vector<Building> buildings;  ///< in the order of the file, including those without faces
  /// In the order of the file and in its coordinates; Face::building is an index into `buildings`.
  std::vector<Face> faces;
  AttributeTable attributes;  ///< attributes of the buildings; row i belongs to buildings[i]
  KindCounts left_out;  ///< contents of the file other than faces of buildings, and unusable faces
  std::vector<std::string> warnings;
};

struct ReadModelOptions {
  /// The level of detail to read: "2.2", or "2" for the highest one of 2.x. If empty, each building
  /// is read in its highest one, up to 3.x.
  std::string lod;
};

}  // namespace ridgeline::io
