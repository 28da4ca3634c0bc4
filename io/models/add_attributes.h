// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/attribute_table.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// Attributes by the id of their building.
using BuildingValues = std::map<std::string, SparseRow>;

/// The text of a CityJSON file, a document or a sequence, with further attributes of its buildings;
/// all else stays. An attribute of the same name is replaced. `columns` are the names of the
/// values. Keys come in the order of their names. Nothing if two objects have the id of one
/// building, as features of a sequence may. Throws IoError as read_cityjson().
std::optional<std::string> with_attributes(const std::string& path,
                                           std::string_view content,
                                           const std::vector<Column>& columns,
                                           const BuildingValues& values);

}  // namespace ridgeline::io
