// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/geopackage_writer.h"

namespace ridgeline::results {

// How the layers of a map of judged lines look when it is opened, as QML and SLD.

/// Lines coloured by `mean_distance_m`, in the steps and colours of the report; grey if they were not judged.
io::MapStyle lines_style();
/// Planes as thin outlines with a light fill.
io::MapStyle planes_style();
/// Faces, or buildings, of a model coloured by `verdict`.
io::MapStyle verdict_style(const std::string& name);
/// Vectors as thin dark lines.
io::MapStyle vectors_style();

}  // namespace ridgeline::results
