// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/geopackage_writer.h"

namespace ridgeline::results {

// Default styles of the layers of a map of judged lines, as QML and SLD.

/// Lines coloured by `mean_distance_m`, with the classes and colours of the report; grey if not
/// judged.
io::MapStyle lines_style();
/// Planes as thin outlines with a light fill.
io::MapStyle planes_style();
/// Buildings as outlines by `verdict`: solid for errors in height, dashed for errors in plan.
io::MapStyle buildings_style();
/// Faces by `verdict`, with a distinct style for each kind of error: filled, hatched, dashed
/// outline.
io::MapStyle faces_style();
/// Markers for what to fix, the first ten larger.
io::MapStyle to_fix_style();
/// Edges of the scan without a line as wide lines.
io::MapStyle missing_style();
/// Roofs of the scan without a building as hatched areas.
io::MapStyle missing_roofs_style();
/// Edges of a scan by `kind`.
io::MapStyle edge_kinds_style();
/// Vectors as thin dark lines.
io::MapStyle vectors_style();

}  // namespace ridgeline::results
