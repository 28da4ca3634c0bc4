// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ridgeline::io {

/// Column types of a vector file. Dates and times are stored as text, "2026/11/24 10:00:00+00".
enum class ColumnType : std::uint8_t {
  kBoolean,
  kInteger,  ///< 32 bits
  kInteger64,
  kReal,
  kText,
  kDate,
  kTime,
  kDateTime,
  kBinary,
};

struct Column {
  std::string name;
  ColumnType type = ColumnType::kText;
};

/// A value: empty, a number (0 or 1 for a boolean), or text.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

/// The values of a feature, each with its column number. Columns without a value are omitted.
using SparseRow = std::vector<std::pair<std::size_t, Value>>;

/// The attributes of all features of a file.
struct AttributeTable {
  std::vector<Column> columns;
  std::vector<SparseRow> rows;
};

/// The value as text; empty if there is no value.
std::string text_of(const Value& value);

/// The type that can represent the values of both types: the wider one of two number types, text
/// for all other pairs.
ColumnType common_type(ColumnType a, ColumnType b);

/// The type of a word of a text file: an integer if printing the number gives the same word ("007"
/// and "+1" are text), real with a point or an exponent, otherwise text.
ColumnType type_of_word(const std::string& word);

/// Converts the values to their columns' types: words to numbers, numbers to words.
void settle_types(AttributeTable& table);

}  // namespace ridgeline::io
