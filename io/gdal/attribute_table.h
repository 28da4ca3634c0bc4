// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ridgeline::io {

/// Types of the columns of a vector file. Dates and times are held as text, "2026/11/24
/// 10:00:00+00".
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

/// A value: empty, a number (0 and 1 of a boolean), or text.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

/// The values that a feature has, each with the number of its column. Columns without a value are
/// left out.
using SparseRow = std::vector<std::pair<std::size_t, Value>>;

/// What the features of a file state, column by column.
struct AttributeTable {
  std::vector<Column> columns;
  std::vector<SparseRow> rows;
};

/// The value as text; empty for none.
std::string text_of(const Value& value);

/// The type that holds the values of both types: for two types of numbers the wider one, for all
/// other pairs text.
ColumnType common_type(ColumnType a, ColumnType b);

/// The type of a word of a text file: an integer if the number is written back as the same word
/// ("007" and "+1" are text), real with a point or an exponent, else text.
ColumnType type_of_word(const std::string& word);

/// Turns the values into those of their columns' types: words into numbers, numbers into words.
void settle_types(AttributeTable& table);

}  // namespace ridgeline::io
