// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/attribute_table.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace ridgeline::io {

/// Fills a table with the attributes of the buildings of a file, one row per building. If a
/// building has several values of the same name, only the first is kept.
class BuildingAttributes {
 public:
  explicit BuildingAttributes(AttributeTable& table) : table_(table) {}

  void begin_row();
  /// Adds a value to the current row. Invalid numbers are kept as text; empty names and words are
  /// left out.
  void add(std::string_view name, std::string_view word, ColumnType type);

 private:
  AttributeTable& table_;
  std::unordered_map<std::string, std::size_t> columns_by_name_;
  std::unordered_set<std::size_t> in_row_;  ///< columns that have a value in the current row
};

}  // namespace ridgeline::io
