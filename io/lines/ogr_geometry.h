// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/feature_collector.h"

#include <ogr_geometry.h>

namespace ridgeline::io {

/// Adds what a geometry holds, however deep in collections; arcs are stroked. A vertex without z
/// has z = NaN.
void collect_geometry(const OGRGeometry& geometry, FeatureGeometry& found);

}  // namespace ridgeline::io
