// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/cloud/mapped_file.h"
#include "io/cloud/point_attribute.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace ridgeline::io {

/// One item of a line: a number that is kept or not, or a list (its length, then as many numbers).
struct TextItem {
  std::optional<PointAttribute> attribute;
  bool is_list = false;
};

/// Lines of numbers separated by blanks, commas or semicolons. Empty lines and those that start
/// with # or // are no rows; items after the listed ones are ignored.
struct TextTable {
  MappedFile file;
  std::size_t offset = 0;            ///< of the first row
  std::uint64_t first_line = 1;      ///< its number, for messages
  std::uint64_t n_skipped_rows = 0;  ///< rows before the points
  std::vector<TextItem> items;
};

/// A source over the rows of `table`: info.n_points of them if `has_row_count`, else all.
/// Throws IoError for missing coordinates or rows; a bad number is an error naming its line when
/// its block is decoded.
std::unique_ptr<CloudSource> open_text_table(TextTable table,
                                             CloudFileInfo info,
                                             bool has_row_count);

}  // namespace ridgeline::io
