// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/geopackage_writer.h"

namespace ridgeline::results {

// How the layers of a map of judged lines look when it is opened, as QML and SLD.

/// Lines coloured by `mean_distance_m`, in the steps and colours of the report; grey if they were
/// not judged.
io::MapStyle lines_style();
/// Planes as thin outlines with a light fill.
io::MapStyle planes_style();
/// Buildings as outlines by `verdict`: solid for heights, dashed for what is wrong in plan.
io::MapStyle buildings_style();
/// Faces by `verdict`, each way to be wrong with a mark of its own: filled, hatched, dashed
/// outline.
io::MapStyle faces_style();
/// Marks of what to fix, the first ten larger.
io::MapStyle to_fix_style();
/// Vectors as thin dark lines.
io::MapStyle vectors_style();

}  // namespace ridgeline::results
