// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <cstdint>
#include <string>

namespace ridgeline::io {

enum class ModelFormat : std::uint8_t {
  kCityJson,  ///< CityJSON 2.0
  kCityGml,   ///< CityGML 2.0
};

/// Writes a model, completely or not at all, with coordinates in thousandths of their unit; equal
/// models give equal bytes.
///
/// In CityJSON, a building whose faces are closed is a Solid, and any other a MultiSurface. CityGML
/// has thematic surfaces and no solids. In both, the kind kOther becomes a ClosureSurface, and
/// kUnknown a face without semantics. The CRS is written if EPSG has codes for it; CityJSON cannot
/// state two codes and then gets only that of the plan. A building without a level of detail gets
/// level 2. In CityGML, ids that are not valid XML names are prefixed with "id_", and invalid
/// characters are replaced by "_". Throws IoError if the file cannot be written, and
/// std::invalid_argument for coordinates that are not finite, for rings of fewer than three
/// vertices, and for buildings that share an id; an empty id becomes "building_N".
void write_model(const std::string& path, const BuildingModel& model, ModelFormat format);

}  // namespace ridgeline::io
