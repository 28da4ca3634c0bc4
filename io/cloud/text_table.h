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

/// Separator of the fields of a row: a character such as ';', blanks (kBlanks), or any of blanks,
/// commas and semicolons (kAnySeparator).
inline constexpr char kAnySeparator = '\0';
inline constexpr char kBlanks = ' ';

/// Iterates over the fields of a row, without surrounding blanks and double quotes. A run of blanks
/// is one separator; two other separators have an empty field between them.
class TextFields {
 public:
  TextFields(std::string_view row, char separator) : rest_(row), separator_(separator) {}

  /// The next field; std::nullopt after the last one.
  std::optional<std::string_view> next();

 private:
  std::optional<std::string_view> next_between_marks();

  std::string_view rest_;
  char separator_;
  bool is_first_ = true;
  bool has_ended_ = false;
};

/// Whether a line is a row: neither blank nor a comment, which starts with # % ! ; or //.
bool is_text_row(std::string_view line);

/// One item of a line: a number that is kept or not, or a list (its length, then that many
/// numbers).
struct TextItem {
  std::optional<PointAttribute> attribute;
  bool is_list = false;
};

/// A table of numbers, with one row per line. Lines for which is_text_row() is false are not rows.
/// Items that are not kept may be text; items after the listed ones are ignored.
struct TextTable {
  MappedFile file;
  std::size_t offset = 0;            ///< byte of the first row
  std::uint64_t first_line = 1;      ///< its line number, for messages
  std::uint64_t n_skipped_rows = 0;  ///< rows before the points
  std::vector<TextItem> items;
  char separator = kAnySeparator;
};

/// Opens the rows of `table` as a source: info.n_points of them if `has_row_count`, otherwise all.
/// Throws IoError for missing coordinates or rows; an invalid number causes an error that names its
/// line when its block is decoded.
std::unique_ptr<CloudSource> open_text_table(TextTable table,
                                             CloudFileInfo info,
                                             bool has_row_count);

}  // namespace ridgeline::io
