// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"

#include <optional>
#include <ostream>
#include <span>
#include <string>

namespace ridgeline::io {

// One writer per format; the model has been checked by write_model().
void write_cityjson(const BuildingModel& model, std::ostream& stream);
void write_citygml(const BuildingModel& model, std::ostream& stream);

/// The EPSG codes of a CRS: one for the whole, or those of its parts.
struct EpsgCodes {
  std::optional<std::string> whole, plane, heights;
};
EpsgCodes epsg_codes_of(const Crs& crs);

/// A coordinate in whole thousandths, as used by both formats.
long long in_thousandths(double coordinate);

/// Whether the faces form closed bodies: each edge of a ring, in thousandths, has exactly one
/// counterpart in the opposite direction.
bool are_closed(std::span<const Face> faces);

/// "RoofSurface" etc.; null for kUnknown.
const char* surface_name(FaceKind kind);

}  // namespace ridgeline::io
