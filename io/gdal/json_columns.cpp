// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/json_columns.h"

#include "io/text/json_text.h"

#include <cstdint>
#include <limits>
#include <utility>

namespace ridgeline::io {
namespace {

using nlohmann::json;

constexpr auto kMaxInteger = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());

std::pair<ColumnType, Value> typed(const json& value) {
  if (value.is_boolean()) return {ColumnType::kBoolean, std::int64_t{value.get<bool>() ? 1 : 0}};
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > kMaxInteger) {
    return {ColumnType::kReal, value.get<double>()};
  }
  if (value.is_number_integer()) return {ColumnType::kInteger64, value.get<std::int64_t>()};
  if (value.is_number()) return {ColumnType::kReal, value.get<double>()};
  return {ColumnType::kText, value.is_string() ? value.get<std::string>() : json_text(value)};
}

}  // namespace

SparseRow JsonColumns::row_of(const json& object, AttributeTable& table) {
  SparseRow row;
  if (!object.is_object()) return row;
  for (const auto& [name, value] : object.items()) {
    if (value.is_null()) continue;
    const auto [type, held] = typed(value);
    row.emplace_back(column_for(name, type, table), held);
  }
  return row;
}

std::size_t JsonColumns::column_for(const std::string& name,
                                    ColumnType type,
                                    AttributeTable& table) {
  std::vector<Column>& columns = table.columns;
  const auto [entry, is_new] = by_name_.try_emplace(name, columns.size());
  if (is_new) columns.push_back({name, type});
  columns[entry->second].type = common_type(columns[entry->second].type, type);
  return entry->second;
}

}  // namespace ridgeline::io
