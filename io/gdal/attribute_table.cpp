// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/attribute_table.h"

#include "io/text/text.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

namespace ridgeline::io {
namespace {

bool is_number(ColumnType type) {
  return type == ColumnType::kInteger || type == ColumnType::kInteger64 ||
         type == ColumnType::kReal;
}

/// Whether the word is an integer that is written back as the same word.
bool is_plain_integer(const std::string& word) {
  const std::optional<long> number = to_integer(word);
  return number && fmt::format("{}", *number) == word;
}

Value as_number(const Value& value, ColumnType type) {
  const auto* const word = std::get_if<std::string>(&value);
  if (type == ColumnType::kReal) {
    if (word != nullptr) return to_double(*word).value_or(std::numeric_limits<double>::quiet_NaN());
    if (const auto* const n = std::get_if<std::int64_t>(&value)) return static_cast<double>(*n);
    return value;
  }
  if (word != nullptr) return static_cast<std::int64_t>(to_integer(*word).value_or(0));
  return value;
}

Value as_text(const Value& value) { return value.index() == 0 ? value : Value(io::text_of(value)); }

}  // namespace

std::string text_of(const Value& value) {
  if (const auto* const n = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *n);
  if (const auto* const x = std::get_if<double>(&value)) return fmt::format("{}", *x);
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  return "";
}

ColumnType common_type(ColumnType a, ColumnType b) {
  if (a == b) return a;
  if (!is_number(a) || !is_number(b)) return ColumnType::kText;
  const bool is_real = a == ColumnType::kReal || b == ColumnType::kReal;
  return is_real ? ColumnType::kReal : ColumnType::kInteger64;
}

ColumnType type_of_word(const std::string& word) {
  if (is_plain_integer(word)) return ColumnType::kInteger64;
  const bool is_fraction = word.find_first_of(".eE") != std::string::npos && !word.starts_with('+');
  const std::optional<double> number = to_double(word);
  return is_fraction && number && std::isfinite(*number) ? ColumnType::kReal : ColumnType::kText;
}

void settle_types(AttributeTable& table) {
  for (SparseRow& row : table.rows) {
    for (auto& [column, value] : row) {
      const ColumnType type = table.columns[column].type;
      if (type == ColumnType::kText) {
        value = as_text(value);
      } else if (is_number(type)) {
        value = as_number(value, type);
      }
    }
  }
}

}  // namespace ridgeline::io
