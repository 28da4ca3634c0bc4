// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/building_attributes.h"

#include "io/text/text.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace ridgeline::io {
namespace {

std::pair<ColumnType, Value> typed_word(const std::string& word, ColumnType type) {
  if (type == ColumnType::kInteger64) {
    if (const std::optional<long> number = to_integer(word)) return {type, std::int64_t{*number}};
  }
  if (type == ColumnType::kReal) {
    const std::optional<double> number = to_double(word);
    if (number && std::isfinite(*number)) return {type, *number};
  }
  return {ColumnType::kText, word};
}

}  // namespace

void BuildingAttributes::begin_row() {
  table_.rows.emplace_back();
  in_row_.clear();
}

void BuildingAttributes::add(std::string_view name, std::string_view word, ColumnType type) {
  const std::string key(trimmed(name));
  const std::string text(trimmed(word));
  if (key.empty() || text.empty()) return;
  const auto [held, value] = typed_word(text, type);
  const auto [entry, is_new] = columns_by_name_.try_emplace(key, table_.columns.size());
  if (is_new) table_.columns.push_back({key, held});
  const std::size_t column = entry->second;
  if (!in_row_.insert(column).second) return;
  table_.columns[column].type = common_type(table_.columns[column].type, held);
  table_.rows.back().emplace_back(column, value);
}

}  // namespace ridgeline::io
