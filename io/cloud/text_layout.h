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
  std::size_t offset = 0;        ///< of the first row
  std::uint64_t first_line = 1;  ///< its number
  char separator = kAnySeparator;
  std::vector<TextItem> items;
};

/// Finds out how a text cloud was written. Before the points may stand, in any order, comments, a number of points
/// alone in its line (.pts), Excel's "sep=;" and names of columns, which may be commented out ("//X Y Z"). Names are
/// taken whatever their case, with quotes and units ("X [m]"), also as surveyors write them ("Easting",
/// "POINT_X"). Without names x, y and z are the first three columns, or the only three of numbers.
/// Decimal commas are read where commas do not separate.
/// Throws IoError for text that leaves open which columns are x, y and z, rather than to guess: names without
/// one of them, two that may be the same, a first column that counts the points, a z that is no height
/// on Earth, rows of another number of columns than is named, commas that separate and mark decimals.
TextLayout find_text_layout(std::string_view text, const std::string& path);

}  // namespace ridgeline::io
