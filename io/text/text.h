// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// A non-blank row of a text file, without its line ending.
struct TextRow {
  int number = 0;  ///< from 1, as in editors
  std::string_view text;
};

/// The non-blank rows, ended by LF or CR LF. The views point into `content`.
std::vector<TextRow> rows_of(std::string_view content);

/// `path:number`, the location given by an IoError about a row.
std::string place(const std::string& path, int row_number);

std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);

/// The trimmed fields of a CSV row. A field in double quotes may contain the separator; "" in it is
/// a quote (RFC 4180). Throws IoError naming `where` for an unclosed quote and for more than 10,000
/// fields.
std::vector<std::string> csv_fields_of(std::string_view row,
                                       char separator,
                                       const std::string& where);

/// Words separated by runs of blanks and tabs.
std::vector<std::string_view> words_of(std::string_view text);

/// Converts the whole text to a number in the C locale; `nan`, `inf` and a leading plus are
/// accepted. std::nullopt if the text is not a number.
std::optional<double> to_double(std::string_view text);
std::optional<long> to_integer(std::string_view text);

/// Converts all words to numbers; throws IoError naming `where` and the first word that is not a
/// number.
std::vector<double> to_doubles(const std::vector<std::string_view>& words,
                               const std::string& where);

}  // namespace ridgeline::io
