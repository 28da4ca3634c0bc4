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
  std::uint64_t first_line = 1;  ///< number of the line of the first row
  char separator = kAnySeparator;
  std::vector<TextItem> items;
};

/// Finds out how a text cloud was written. Comments, a number of points alone in its line (.pts),
/// Excel's "sep=;" and names of columns may stand before the points, in any order. The names may be
/// commented out ("//X Y Z"). They are taken in any case, with quotes, and by all the names that
/// column_name() has for x, y and z ("X [m]", "Easting", "POINT_X"). Without names, x, y and z are
/// the first three columns. Decimal commas are read if commas do not separate. Throws IoError for
/// text that leaves open which columns are x, y and z, rather than to guess: two names that may be
/// the same axis, rows with more columns than are named, first columns that are no numbers, that
/// count the points, or give a z that is no height on Earth.
TextLayout find_text_layout(std::string_view text, const std::string& path);

}  // namespace ridgeline::io
