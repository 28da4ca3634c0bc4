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

/// Writes a model, whole or not at all, with coordinates in millimetres of their unit; equal models
/// give equal bytes.
///
/// CityJSON has a Solid for a building whose faces close, and a MultiSurface for the others.
/// CityGML has thematic surfaces and no solid. In both, the kind kOther becomes a ClosureSurface,
/// and kUnknown a face without semantics. The CRS is written if EPSG has codes for it; CityJSON has
/// no form for two codes and then gets that of the plan alone. A building without a level of detail
/// gets 2. Ids that are no names in XML begin with "id_" in CityGML and have "_" for what a name
/// must not have. Throws IoError if the file cannot be written, and std::invalid_argument for
/// coordinates that are not finite, for rings of fewer than three vertices, and for buildings that
/// share an id; an empty id becomes "building_N".
void write_model(const std::string& path, const BuildingModel& model, ModelFormat format);

}  // namespace ridgeline::io
