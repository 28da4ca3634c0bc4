// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/attribute_table.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <unordered_map>

namespace ridgeline::io {

/// Converts JSON objects to rows of a table, with one column for each name. settle_types() must
/// complete the table.
class JsonColumns {
 public:
  /// The members that are not null; arrays and objects as JSON text. The row is empty for anything
  /// but an object. Columns with new names are added to the table.
  SparseRow row_of(const nlohmann::json& object, AttributeTable& table);

 private:
  std::size_t column_for(const std::string& name, ColumnType type, AttributeTable& table);

  std::unordered_map<std::string, std::size_t> by_name_;
};

}  // namespace ridgeline::io
