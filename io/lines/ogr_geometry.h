// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/feature_collector.h"

#include <ogr_geometry.h>

namespace ridgeline::io {

/// Adds the contents of a geometry, including nested collections; arcs become line strings. A
/// vertex without z has z = NaN.
void collect_geometry(const OGRGeometry& geometry, FeatureGeometry& found);

}  // namespace ridgeline::io
