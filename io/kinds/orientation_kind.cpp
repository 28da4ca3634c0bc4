// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/orientation_kind.h"

#include "io/text/pat_b_record.h"
#include "io/text/table_row.h"
#include "io/text/text.h"
#include "io/text/utf8.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

bool has_part(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool all_numbers(std::span<const std::string_view> words) {
  return std::ranges::all_of(
      words, [](std::string_view word) { return fortran_number(word).has_value(); });
}

std::optional<OrientationFormat> format_of_xml(std::string_view start) {
  if (has_part(start, "<BlocksExchange")) return OrientationFormat::kBlocksExchange;
  if (has_part(start, "<document") && has_part(start, "<chunk"))
    return OrientationFormat::kMetashape;
  return std::nullopt;
}

/// Number and position, then five and four elements of a matrix that are at most 1.
bool is_pat_b(std::span<const TextRow> rows) {
  if (rows.size() < 3) return false;
  const std::vector<std::string_view> head = pat_b_words(rows[0].text, 4);
  if (head.size() != 4 && head.size() != 5) return false;
  if (!all_numbers(std::span(head).subspan(1))) return false;
  for (const std::size_t row : {1U, 2U}) {
    const std::vector<std::string_view> words = pat_b_words(rows[row].text, 6 - row);
    const bool is_element = std::ranges::all_of(words, [](std::string_view word) {
      const std::optional<double> value = fortran_number(word);
      return value && *value >= -1.0 && *value <= 1.0;
    });
    if (words.size() != 6 - row || !is_element) return false;
  }
  return true;
}

/// A row of a table without column names: a name that is not a number and may contain blanks, six
/// numbers and optionally a camera.
bool is_opk_row(std::string_view row) {
  constexpr int kNumbers = 6;
  const std::vector<std::string> fields = table_fields(row, separator_of(row));
  if (fields.size() < kNumbers + 1 || table_number(fields[0])) return false;
  const auto is_number = [](const std::string& field) { return table_number(field).has_value(); };
  if (std::ranges::count_if(fields, is_number) > kNumbers + 1) return false;  // some other table
  return std::all_of(fields.begin() + 1, fields.begin() + 1 + kNumbers, is_number) ||
         std::all_of(fields.end() - kNumbers, fields.end(), is_number);
}

/// Whether rows begin an OBJ: a vertex, then another record. A vertex with a colour,
/// `v x y z r g b`, looks like the orientation of an image called "v".
bool begins_as_obj(std::span<const TextRow> rows) {
  constexpr std::array kRecords{"v", "vn", "vt", "vp", "p", "l", "f", "o", "g", "s", "usemtl"};
  if (rows.size() < 2 || words_of(rows[0].text).front() != "v") return false;
  return std::ranges::find(kRecords, words_of(rows[1].text).front()) != kRecords.end();
}

bool is_roll_pitch_yaw(std::string_view row) {
  const std::string text = lower_case(row);
  return has_part(text, "roll") && has_part(text, "pitch") && has_part(text, "yaw");
}

std::optional<OrientationFormat> format_of_rows(std::span<const TextRow> rows) {
  for (const TextRow& row : rows) {
    if (!opk_columns(row.text).empty()) return OrientationFormat::kOpkTable;
    if (is_roll_pitch_yaw(row.text)) return OrientationFormat::kRollPitchYaw;
    if (!is_comment_row(row.text)) break;
  }
  std::vector<TextRow> records(rows.begin(), rows.end());
  std::erase_if(records, [](const TextRow& row) { return is_comment_row(row.text); });
  if (records.empty() || begins_as_obj(records)) return std::nullopt;
  if (is_pat_b(records)) return OrientationFormat::kPatB;
  if (is_opk_row(records.front().text)) return OrientationFormat::kOpkTable;
  return std::nullopt;
}

}  // namespace

std::optional<OrientationFormat> orientation_format(std::string_view bytes) {
  const std::string start = as_utf8(bytes);
  const std::vector<TextRow> rows = rows_of(start);
  if (rows.empty()) return std::nullopt;
  const std::string_view first = rows.front().text;
  if (first.starts_with('<')) return format_of_xml(start);
  if (first.starts_with('[')) {
    const bool is_opensfm =
        has_part(start, "\"cameras\"") &&
        (has_part(start, "\"projection_type\"") || has_part(start, "\"shots\""));
    return is_opensfm ? std::optional(OrientationFormat::kOpensfm) : std::nullopt;
  }
  if (first.starts_with("fileName imageWidth imageHeight")) return OrientationFormat::kPix4d;
  if (first.starts_with("$PROJECT") || first.starts_with("$CAMERA") ||
      first.starts_with("$PHOTO")) {
    return OrientationFormat::kInpho;
  }
  return format_of_rows(rows);
}

const char* what_is(OrientationFormat format) {
  using enum OrientationFormat;
  static constexpr std::array kNames{
      std::pair{kOpkTable, "an orientation of images (omega, phi, kappa)"},
      std::pair{kRollPitchYaw, "a table of roll, pitch and yaw"},
      std::pair{kOpensfm, "an orientation of images (OpenSfM)"},
      std::pair{kPix4d, "an orientation of images (Pix4D)"},
      std::pair{kInpho, "an orientation of images (Inpho project)"},
      std::pair{kPatB, "an orientation of images (PAT-B)"},
      std::pair{kBlocksExchange, "an orientation of images (BlocksExchange)"},
      std::pair{kMetashape, "an orientation of images (Metashape)"}};
  return std::ranges::find(kNames, format, &std::pair<OrientationFormat, const char*>::first)
      ->second;
}

}  // namespace ridgeline::io
