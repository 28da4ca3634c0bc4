// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judged_model.h"
#include "evaluate/files/map_layers.h"
#include "evaluate/statistics/completeness.h"
#include "io/gdal/geopackage_writer.h"

#include <vector>

namespace ridgeline::results {

/// The layer `missing`: the edges of the scan that lines should show and do not.
io::MapLayer missing_layer(const evaluate::Completeness& completeness, const ToMap& to_map);

/// The layer `missing_roofs` of a model.
io::MapLayer missing_roofs_layer(const std::vector<MissingRoof>& roofs, const ToMap& to_map);

}  // namespace ridgeline::results
