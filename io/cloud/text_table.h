// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/cloud/point_attribute.h"
#include "io/files/mapped_file.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// What separates the fields of a row: a mark such as ';', or blanks (kBlanks), or blanks, commas
/// and semicolons alike (kAnySeparator).
inline constexpr char kAnySeparator = '\0';
inline constexpr char kBlanks = ' ';

/// Walks the fields of a row, without the blanks and the double quotes around them. Blanks in a run
/// are one separator; two other separators have an empty field between them.
class TextFields {
 public:
  TextFields(std::string_view row, char separator) : rest_(row), separator_(separator) {}

  /// The next field; nothing after the last one.
  std::optional<std::string_view> next();

 private:
  std::optional<std::string_view> next_between_marks();

  std::string_view rest_;
  char separator_;
  bool is_first_ = true;
  bool has_ended_ = false;
};

/// Whether a line is a row: not blank, and no comment, which starts with # % ! ; or //.
bool is_text_row(std::string_view line);

/// A number of a table, with a point or a comma before its decimals; the comma only where it can
/// be nothing else: "1,5" but not "1,500.0" or "1,500,000".
std::optional<double> table_number(std::string_view field);

/// One item of a line: a number that is kept or not, or a list (its length, then as many numbers).
struct TextItem {
  std::optional<PointAttribute> attribute;
  bool is_list = false;
};

/// A table of numbers, with one row a line. Lines for which is_text_row() is false are no rows.
/// Items that are not kept may be text; those after the listed ones are ignored.
struct TextTable {
  MappedFile file;
  std::size_t offset = 0;            ///< byte of the first row
  std::uint64_t first_line = 1;      ///< number of its line, for messages
  std::uint64_t n_skipped_rows = 0;  ///< rows before the points
  std::vector<TextItem> items;
  char separator = kAnySeparator;
};

/// A source over the rows of `table`: info.n_points of them if `has_row_count`, else all.
/// Throws IoError for missing coordinates or rows; a bad number is an error naming its line when
/// its block is decoded.
std::unique_ptr<CloudSource> open_text_table(TextTable table,
                                             CloudFileInfo info,
                                             bool has_row_count);

}  // namespace ridgeline::io
