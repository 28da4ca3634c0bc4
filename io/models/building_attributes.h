// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/attribute_table.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace ridgeline::io {

/// Fills a table with what a file states of its buildings, one row each. A value whose name a
/// building has already had is left out.
class BuildingAttributes {
 public:
  explicit BuildingAttributes(AttributeTable& table) : table_(table) {}

  void begin_row();
  /// Adds a value to the row that has begun. Numbers that are none are kept as text; empty names
  /// and words are left out.
  void add(std::string_view name, std::string_view word, ColumnType type);

 private:
  AttributeTable& table_;
  std::unordered_map<std::string, std::size_t> columns_by_name_;
  std::unordered_set<std::size_t> in_row_;  ///< columns
};

}  // namespace ridgeline::io
