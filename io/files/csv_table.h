// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/recognise.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

struct TextRow;

/// A comma-separated table with a header, in the form that the program itself writes.
class CsvTable {
 public:
  /// Throws IoError for a file that cannot be read or is empty, for one that is recognised as a
  /// kind other than `expected`, and for a row whose number of fields differs from the header's.
  explicit CsvTable(const std::string& path, std::optional<FileGroup> expected = std::nullopt);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Whether there is a column of this name, given in lower case. The header may use any case.
  [[nodiscard]] bool has(std::string_view column) const { return find(column).has_value(); }
  /// Throws IoError naming the column if it does not exist.
  [[nodiscard]] std::size_t column(std::string_view name) const;

  [[nodiscard]] std::string_view text(std::size_t row, std::size_t column) const {
    return rows_[row].fields[column];
  }
  /// The value as a finite number. Throws IoError naming row and value if it is not one.
  [[nodiscard]] double number(std::size_t row, std::size_t column) const;
  /// The value as an index (0, 1, ...). Throws IoError naming row and value if it is not one.
  [[nodiscard]] int index(std::size_t row, std::size_t column) const;

  /// `path:row`, for messages.
  [[nodiscard]] std::string place_of(std::size_t row) const;

 private:
  struct Row {
    int number = 0;
    std::vector<std::string_view> fields;
  };
  std::vector<std::string_view> fields_of(const TextRow& row);
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;

  std::string path_, content_;
  /// Fields of rows with quotes; the other fields are views into content_.
  std::deque<std::vector<std::string>> quoted_;
  std::vector<std::string> names_;
  std::vector<Row> rows_;
};

}  // namespace ridgeline::io
