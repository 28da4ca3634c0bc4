// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/text_table.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// Where the points of a text file begin, and what its columns are.
struct TextLayout {
  std::size_t offset = 0;        ///< byte of the first row
  std::uint64_t first_line = 1;  ///< line number of the first row
  char separator = kAnySeparator;
  std::vector<TextItem> items;
};

/// Determines the layout of a text cloud. Comments, the number of points on a line by itself
/// (.pts), Excel's "sep=;" and column names may precede the points, in any order. The names may be
/// commented out ("//X Y Z"). They are matched regardless of case and quotes, with all the names
/// that column_name() has for x, y and z ("X [m]", "Easting", "POINT_X"). Without names, x, y and z
/// are the first three columns. Decimal commas are read if commas do not separate fields. Rather
/// than guess, throws IoError for text that leaves open which columns are x, y and z: two names
/// that may mean the same axis, rows with more columns than are named, or first columns that are
/// not numbers, that number the points, or that give a z that is not a height on Earth.
TextLayout find_text_layout(std::string_view text, const std::string& path);

}  // namespace ridgeline::io
