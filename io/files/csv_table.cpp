// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/csv_table.h"

#include "io/error.h"
#include "io/files/input_file.h"
#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::io {
namespace {

std::vector<std::string_view> plain_fields_of(std::string_view row) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t comma = row.find(',');
    fields.push_back(trimmed(row.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    row.remove_prefix(comma + 1);
  }
}

}  // namespace

CsvTable::CsvTable(const std::string& path, std::optional<FileGroup> expected)
    : path_(path), content_(read_input(path, expected)) {
  const std::vector<TextRow> rows = rows_of(content_);
  if (rows.empty()) throw IoError(path, "is empty; a header with column names is expected");
  for (const std::string_view name : fields_of(rows.front())) names_.push_back(lower_case(name));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    rows_.push_back({rows[i].number, fields_of(rows[i])});
    if (rows_.back().fields.size() != names_.size()) {
      throw IoError(place_of(i - 1), fmt::format("{} fields, the header has {}",
                                                 rows_.back().fields.size(), names_.size()));
    }
  }
}

std::vector<std::string_view> CsvTable::fields_of(const TextRow& row) {
  if (row.text.find('"') == std::string_view::npos) return plain_fields_of(row.text);
  quoted_.push_back(csv_fields_of(row.text, ',', place(path_, row.number)));
  return {quoted_.back().begin(), quoted_.back().end()};
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto it = std::find(names_.begin(), names_.end(), column);
  if (it == names_.end()) return std::nullopt;
  return static_cast<std::size_t>(it - names_.begin());
}

std::size_t CsvTable::column(std::string_view name) const {
  if (const auto found = find(name)) return *found;
  throw IoError(path_, fmt::format("no column {}", name));
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::optional<double> value = to_double(text(row, column));
  if (!value || !std::isfinite(*value)) {
    throw IoError(place_of(row), fmt::format("{} = '{}', must be a finite number", names_[column],
                                             text(row, column)));
  }
  return *value;
}

int CsvTable::index(std::size_t row, std::size_t column) const {
  const std::optional<long> value = to_integer(text(row, column));
  if (!value || *value < 0 || *value > std::numeric_limits<int>::max()) {
    throw IoError(place_of(row), fmt::format("{} = '{}', must be an index: 0, 1, ...",
                                             names_[column], text(row, column)));
  }
  return static_cast<int>(*value);
}

std::string CsvTable::place_of(std::size_t row) const { return place(path_, rows_[row].number); }

}  // namespace ridgeline::io
