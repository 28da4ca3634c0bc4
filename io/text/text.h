// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// A row of a text file that is not blank, without its line end.
struct TextRow {
  int number = 0;  ///< from 1, as editors count
  std::string_view text;
};

/// The rows that are not blank, with line ends LF or CR LF. The views point into `content`.
std::vector<TextRow> rows_of(std::string_view content);

/// `path:number`, the place that an IoError about a row names.
std::string place(const std::string& path, int row_number);

std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);

/// The trimmed fields of a row of CSV. A field in double quotes may hold the separator; "" in it is
/// a quote (RFC 4180). Throws IoError naming the place for a quote that is not closed and for more
/// than 10,000 fields.
std::vector<std::string> csv_fields_of(std::string_view row,
                                       char separator,
                                       const std::string& where);

/// Words between runs of blanks and tabs.
std::vector<std::string_view> words_of(std::string_view text);

/// The number that the whole text is, in the C locale; `nan` and `inf` are numbers, a leading plus
/// is taken. Nothing if it is no number.
std::optional<double> to_double(std::string_view text);
std::optional<long> to_integer(std::string_view text);

/// All words as numbers; throws IoError naming the place and the first word that is none.
std::vector<double> to_doubles(const std::vector<std::string_view>& words,
                               const std::string& where);

}  // namespace ridgeline::io
