// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/attribute_table.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// Attributes by building id.
using BuildingValues = std::map<std::string, SparseRow>;

/// The text of a CityJSON file (a document or a sequence) with additional attributes of its
/// buildings; everything else stays unchanged. `columns` are the names of the values. An attribute
/// of one of these names is replaced, or removed if it has no new value. Keys are sorted by name.
/// Returns std::nullopt if two objects have the id of one building, as is possible in a sequence.
/// Throws IoError under the same conditions as read_cityjson().
std::optional<std::string> with_attributes(const std::string& path,
                                           std::string_view content,
                                           const std::vector<Column>& columns,
                                           const BuildingValues& values);

}  // namespace ridgeline::io
