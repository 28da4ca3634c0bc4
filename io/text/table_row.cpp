// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/table_row.h"

#include "io/text/text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace ridgeline::io {
namespace {

struct Synonyms {
  const char* name;
  std::array<std::string_view, 12> spellings;
};

constexpr std::array kColumns{
    Synonyms{"name",
             {"filename", "name", "image", "imagename", "label", "photoid", "nom", "photo", "id",
              "bildname", "bild"}},
    Synonyms{"x",
             {"x", "e", "easting", "east", "x0", "x/easting", "point_x", "x_coord", "rechtswert"}},
    Synonyms{"y",
             {"y", "n", "northing", "north", "y0", "y/northing", "point_y", "y_coord", "hochwert"}},
    Synonyms{"z",
             {"z", "h", "height", "altitude", "elevation", "z0", "alt", "z/altitude", "point_z",
              "z_coord", "h\xc3\xb6he", "h\xc3\x96he"}},
    Synonyms{"omega", {"omega", "o", "w", "om"}},
    Synonyms{"phi", {"phi", "p", "ph"}},
    Synonyms{"kappa", {"kappa", "k", "kap", "ka"}},
    Synonyms{"camera", {"camera", "cam", "cameraid", "camera_id"}},
    Synonyms{"roll", {"roll"}},
    Synonyms{"latitude", {"latitude", "lat"}}};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// A name without its unit: "x [m]", "omega(deg)", "kappa_gon".
std::string_view without_unit(std::string_view name) {
  name = trimmed(name.substr(0, name.find_first_of("[(")));
  constexpr std::array<std::string_view, 8> kUnits{"_m",    "_deg", "_degree", "_degrees",
                                                   "_grad", "_gon", "_rad",    "_radians"};
  for (const std::string_view unit : kUnits) {
    if (name.ends_with(unit)) return name.substr(0, name.size() - unit.size());
  }
  return name;
}

/// Whether a word is a number whose decimal mark is a comma.
bool has_decimal_comma(std::string_view word) {
  const std::size_t comma = word.find(',');
  return comma != std::string_view::npos && comma + 1 < word.size() && table_number(word);
}

}  // namespace

std::optional<double> table_number(std::string_view field) {
  constexpr std::size_t kMaxLength = 64;
  if (field.starts_with('+')) field.remove_prefix(1);  // from_chars takes no plus sign
  std::array<char, kMaxLength> with_point{};
  if (const std::size_t comma = field.find(','); comma != std::string_view::npos) {
    if (field.size() > kMaxLength ||
        field.find_first_of(",.", comma + 1) != std::string_view::npos ||
        field.find('.') != std::string_view::npos) {
      return std::nullopt;
    }
    std::ranges::copy(field, with_point.begin());
    with_point[comma] = '.';
    field = {with_point.data(), field.size()};
  }
  double value = 0.0;
  const char* const last = field.data() + field.size();
  const auto [end, error] = std::from_chars(field.data(), last, value);
  if (field.empty() || error != std::errc{} || end != last) return std::nullopt;
  return value;
}

char separator_of(std::string_view row) {
  for (const char separator : {';', '\t'}) {
    if (row.find(separator) != std::string_view::npos) return separator;
  }
  if (row.find(',') == std::string_view::npos) return ' ';
  return std::ranges::count_if(words_of(row), has_decimal_comma) >= 3 ? ' ' : ',';
}

bool is_comment_row(std::string_view row) {
  return row.starts_with('#') || row.starts_with("//") || row.starts_with("sep=");
}

std::vector<std::string> table_fields(std::string_view row, char separator) {
  std::vector<std::string> fields(1);
  char quote = '\0';
  const auto begin_field = [&] {
    if (separator != ' ' || !fields.back().empty()) fields.emplace_back();
  };
  for (const char c : row) {
    if (quote != '\0') {
      if (c == quote)
        quote = '\0';
      else
        fields.back() += c;
    } else if (c == '"' || (c == '\'' && trimmed(fields.back()).empty())) {
      quote = c;
    } else if (c == separator || (separator == ' ' && is_blank(c))) {
      begin_field();
    } else {
      fields.back() += c;
    }
  }
  if (separator == ' ' && fields.back().empty()) fields.pop_back();
  for (std::string& field : fields) field = std::string(trimmed(field));
  return fields;
}

std::string column_name(std::string_view name) {
  const std::string lower = lower_case(name);
  const std::string_view bare = without_unit(trimmed(lower));
  for (const Synonyms& column : kColumns) {
    if (bare.empty()) break;
    if (std::ranges::find(column.spellings, bare) != column.spellings.end()) return column.name;
  }
  return std::string(bare);
}

std::vector<std::string> opk_columns(std::string_view row) {
  const std::size_t first = row.find_first_not_of("# \t/");
  if (first == std::string_view::npos) return {};
  row.remove_prefix(first);
  std::vector<std::string> columns;
  for (const std::string& field : table_fields(row, separator_of(row))) {
    columns.push_back(column_name(field));
  }
  const bool is_header =
      std::ranges::all_of(std::array{"x", "y", "z", "omega", "phi", "kappa"},
                          [&](const char* name) { return std::ranges::count(columns, name) == 1; });
  return is_header ? columns : std::vector<std::string>();
}

}  // namespace ridgeline::io
