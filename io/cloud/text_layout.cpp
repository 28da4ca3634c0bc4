// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/text_layout.h"

#include "io/error.h"
#include "io/text/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace ridgeline::io {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::size_t kSampledRows = 50;

struct LayoutLine {
  std::string_view text;
  std::uint64_t number = 0;
  std::size_t offset = 0;
};

/// The lines of a text, found one by one, as only the first few are looked at.
class LayoutLines {
 public:
  LayoutLines(std::string_view text, std::size_t offset) : text_(text), offset_(offset) {}

  std::optional<LayoutLine> next() {
    if (offset_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
    LayoutLine line{text_.substr(offset_, end - offset_), ++number_, offset_};
    offset_ = end + 1;
    return line;
  }

  std::optional<LayoutLine> next_row() {
    std::optional<LayoutLine> line = next();
    while (line && !is_text_row(line->text)) line = next();
    return line;
  }

 private:
  std::string_view text_;
  std::size_t offset_;
  std::uint64_t number_ = 0;
};

Fields fields_of(std::string_view row, char separator) {
  Fields fields;
  TextFields walker(row, separator);
  while (const auto field = walker.next()) fields.push_back(*field);
  return fields;
}

bool has_char(std::string_view text, char c) { return text.find(c) != std::string_view::npos; }

bool has_letter(std::string_view text) {
  return std::ranges::any_of(
      text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
}

std::string shown(std::string_view text) {
  constexpr std::size_t kShown = 60;
  return std::string(trimmed(text).substr(0, kShown));
}

/// Whether the field is a number such as "1,5", with the decimal comma of half of the world.
bool has_decimal_comma(std::string_view field) {
  return has_char(field, ',') && table_number(field);
}

/// Whether commas group the thousands of a number: "512,999.314" or "5,403,002".
bool groups_thousands(std::string_view field) {
  if (field.starts_with('-')) field.remove_prefix(1);
  const std::string_view whole = field.substr(0, field.find('.'));
  if (!has_char(whole, ',') || (whole.size() == field.size() && std::ranges::count(whole, ',') < 2))
    return false;
  const Fields groups = fields_of(whole, ',');
  return std::ranges::all_of(groups, [&](std::string_view group) {
    const bool is_first = group.data() == whole.data();
    const bool fits = is_first ? !group.empty() && group.size() <= 3 : group.size() == 3;
    return fits && group.find_first_not_of("0123456789") == std::string_view::npos;
  });
}

/// A column's name without case, units in brackets, blanks and the marks that join words: "POINT_X"
/// -> "pointx", "X [m]" -> "x".
std::string plain_name(std::string_view name) {
  std::string plain;
  int depth = 0;
  for (const char c : lower_case(name)) {
    if (c == '[' || c == '(') ++depth;
    if (depth == 0 && std::string_view(" _-.\"'").find(c) == std::string_view::npos) plain += c;
    if (c == ']' || c == ')') depth = std::max(0, depth - 1);
  }
  return plain;
}

/// The axis that a column is likely to be, by the names that surveyors and other programs use;
/// attribute_of_column() knows the plain ones.
std::optional<PointAttribute> axis_by_other_name(std::string_view name) {
  using namespace std::string_view_literals;
  static constexpr std::array kX{
      "x"sv, "xcoord"sv, "xcoordinate"sv, "coordx"sv,   "pointx"sv,  "posx"sv,       "xm"sv,
      "e"sv, "east"sv,   "easting"sv,     "eastings"sv, "ostwert"sv, "rechtswert"sv, "rw"sv};
  static constexpr std::array kY{
      "y"sv, "ycoord"sv, "ycoordinate"sv, "coordy"sv,    "pointy"sv,   "posy"sv,     "ym"sv,
      "n"sv, "north"sv,  "northing"sv,    "northings"sv, "nordwert"sv, "hochwert"sv, "hw"sv};
  static constexpr std::array kZ{"z"sv,      "zcoord"sv,    "zcoordinate"sv, "coordz"sv,
                                 "pointz"sv, "posz"sv,      "zm"sv,          "h"sv,
                                 "height"sv, "elevation"sv, "elev"sv,        "altitude"sv,
                                 "alt"sv,    "hoehe"sv,     "h\xc3\xb6he"sv, "h\xf6he"sv};
  const std::string plain = plain_name(name);
  const auto is_among = [&](const auto& names) {
    return std::ranges::find(names, std::string_view(plain)) != std::end(names);
  };
  if (is_among(kX)) return PointAttribute::kX;
  if (is_among(kY)) return PointAttribute::kY;
  if (is_among(kZ)) return PointAttribute::kZ;
  return std::nullopt;
}

constexpr std::array kAxes{std::pair{PointAttribute::kX, 'x'}, std::pair{PointAttribute::kY, 'y'},
                           std::pair{PointAttribute::kZ, 'z'}};

/// What a line of column names says.
struct ColumnNames {
  std::uint64_t line = 0;
  std::vector<std::string> names;
  std::vector<TextItem> items;

  [[nodiscard]] std::size_t count(PointAttribute attribute) const {
    return static_cast<std::size_t>(std::ranges::count(items, attribute, &TextItem::attribute));
  }
  [[nodiscard]] bool has_all_axes() const {
    return std::ranges::all_of(kAxes, [&](const auto& axis) { return count(axis.first) > 0; });
  }
};

char separator_of_names(std::string_view line) {
  for (const char mark : {';', '\t', ','}) {
    if (has_char(line, mark)) return mark;
  }
  return kBlanks;
}

ColumnNames column_names(const LayoutLine& line) {
  std::string_view text = line.text;
  text.remove_prefix(std::min(text.find_first_not_of("#/%!; \t"), text.size()));
  ColumnNames columns{.line = line.number, .names = {}, .items = {}};
  for (const std::string_view name : fields_of(text, separator_of_names(text))) {
    columns.names.emplace_back(name);
    columns.items.push_back({.attribute = attribute_of_column(name)});
  }
  for (const auto& [axis, letter] : kAxes) {
    if (columns.count(axis) > 0) continue;
    for (std::size_t i = 0; i < columns.items.size(); ++i) {
      if (!columns.items[i].attribute && axis_by_other_name(columns.names[i]) == axis) {
        columns.items[i].attribute = axis;
      }
    }
  }
  return columns;
}

class LayoutFinder {
 public:
  LayoutFinder(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  TextLayout find() {
    skip_byte_order_mark();
    LayoutLines lines(text_, layout_.offset);
    while (const auto line = lines.next()) {
      if (is_text_row(line->text) ? is_first_point(*line, lines) : is_named_by_comment(*line))
        break;
    }
    if (sample_.empty()) {
      layout_.offset = text_.size();
      layout_.items = columns_ ? columns_->items : first_three(0);
      return layout_;
    }
    layout_.offset = sample_.front().offset;
    layout_.first_line = sample_.front().number;
    for (auto row = lines.next_row(); row && sample_.size() < kSampledRows;
         row = lines.next_row()) {
      sample_.push_back(*row);
    }
    if (columns_) {
      take_named_columns();
    } else {
      take_columns_by_place();
    }
    return layout_;
  }

 private:
  [[noreturn]] void fail(const LayoutLine& line, const std::string& message) const {
    throw IoError(path_, fmt::format("line {}: {}", line.number, message));
  }

  void skip_byte_order_mark() {
    if (text_.starts_with("\xef\xbb\xbf")) layout_.offset = 3;
  }

  /// Takes a comment for the names of the columns if it names all axes. Returns false, as the
  /// points are still to come.
  bool is_named_by_comment(const LayoutLine& line) {
    ColumnNames columns = column_names(line);
    if (columns.has_all_axes()) columns_ = std::move(columns);
    return false;
  }

  /// Whether a row is the first point, and not a count, a separator or names of columns.
  bool is_first_point(const LayoutLine& line, const LayoutLines& lines) {
    const std::string_view text = trimmed(line.text);
    if (lower_case(text.substr(0, 4)) == "sep=") return false;
    if (is_count(text, lines)) return false;
    const Fields fields = fields_of(text, kAnySeparator);
    const auto n_numbers = std::ranges::count_if(
        fields, [](std::string_view field) { return table_number(field).has_value(); });
    ColumnNames columns = column_names(line);
    if (columns.has_all_axes()) {
      columns_ = std::move(columns);
      return false;
    }
    if (n_numbers < 3 && !columns_ && has_letter(text)) fail_names(line, columns);
    sample_.push_back(line);
    return true;
  }

  static bool is_count(std::string_view text, LayoutLines lines) {
    const bool is_whole = text.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_whole) return false;
    const auto following = lines.next_row();
    return !following || fields_of(following->text, kAnySeparator).size() >= 3;
  }

  [[noreturn]] void fail_names(const LayoutLine& line, const ColumnNames& columns) const {
    std::string missing;
    for (const auto& [axis, letter] : kAxes) {
      if (columns.count(axis) > 0) continue;
      if (!missing.empty()) missing += ", ";
      missing += letter;
    }
    fail(line,
         fmt::format("\"{}\" has no column {}; x, y and z are needed", shown(line.text), missing));
  }

  static std::vector<TextItem> first_three(std::size_t first) {
    std::vector<TextItem> items(first);
    for (const auto& [axis, letter] : kAxes) items.push_back({.attribute = axis});
    return items;
  }

  void refuse_thousands(const LayoutLine& row, const Fields& fields) const {
    const auto found = std::ranges::find_if(fields, groups_thousands);
    if (found == fields.end()) return;
    fail(row, fmt::format("\"{}\" has marks between its thousands; write numbers without them",
                          shown(*found)));
  }

  /// The separator of a row of points. Commas mark decimals if another mark separates the fields.
  [[nodiscard]] char separator_of_points(std::string_view row) const {
    if (has_char(row, ';')) return ';';
    if (columns_ && has_char(row, '\t')) return '\t';
    if (!has_char(row, ',')) return kBlanks;
    const Fields words = fields_of(row, kBlanks);
    const auto is_number = [](std::string_view word) { return table_number(word).has_value(); };
    const bool is_apart = words.size() >= 3 && std::ranges::any_of(words, has_decimal_comma) &&
                          std::ranges::all_of(std::span(words).first(3), is_number);
    return is_apart ? kBlanks : ',';
  }

  void take_named_columns() {
    const ColumnNames& columns = *columns_;
    const LayoutLine& row = sample_.front();
    for (const auto& [axis, letter] : kAxes) {
      if (columns.count(axis) == 1) continue;
      throw IoError(
          path_, fmt::format("line {}: {} columns may be {}: {}; name one of them {}", columns.line,
                             columns.count(axis), letter, fmt::join(columns.names, ", "), letter));
    }
    layout_.separator = separator_of_points(row.text);
    layout_.items = columns.items;
    const Fields fields = fields_of(row.text, layout_.separator);
    if (layout_.separator == kBlanks) refuse_thousands(row, fields);
    refuse_other_count(row, fields);
    for (std::size_t i = 0; i < std::min(fields.size(), layout_.items.size()); ++i) {
      auto& attribute = layout_.items[i].attribute;
      const bool is_text = attribute && *attribute > PointAttribute::kZ && !fields[i].empty() &&
                           !table_number(fields[i]);
      if (is_text) attribute.reset();  // the column holds text, such as names of classes
    }
    drop_trailing_items();
  }

  /// Refuses a row with more fields than names, as a name may then belong to another field than the
  /// one in its place.
  void refuse_other_count(const LayoutLine& row, Fields fields) const {
    while (!fields.empty() && fields.back().empty()) fields.pop_back();
    const std::size_t n_named = columns_->names.size();
    if (fields.size() <= n_named) return;
    const bool splits_decimals = layout_.separator == ',' && fields.size() == 2 * n_named;
    fail(row,
         splits_decimals
             ? "commas separate columns and mark decimals; write decimal points, or semicolons "
               "between the columns"
             : fmt::format("has {} columns but line {} names {}; name all of them", fields.size(),
                           columns_->line, n_named));
  }

  void take_columns_by_place() {
    const LayoutLine& row = sample_.front();
    refuse_thousands(row, fields_of(row.text, kBlanks));
    refuse_split_decimals();
    const char separator = separator_of_points(row.text);
    const Fields own = fields_of(row.text, separator);
    const bool has_commas = separator != ',' && std::ranges::any_of(own, has_decimal_comma);
    const bool has_quotes = has_char(row.text, '"');
    layout_.separator = has_commas || has_quotes ? separator : kAnySeparator;
    const Fields fields = fields_of(row.text, layout_.separator);
    layout_.items = items_by_place(row, fields);
    refuse_running_number();
    refuse_impossible_height(row, fields);
    drop_trailing_items();
  }

  [[nodiscard]] std::vector<TextItem> items_by_place(const LayoutLine& row,
                                                     const Fields& fields) const {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (table_number(fields[i])) numbers.push_back(i);
    }
    const bool begins_with_numbers = numbers.size() >= 3 && numbers[2] == 2;
    if (begins_with_numbers || fields.size() < 3) return first_three(0);
    if (numbers.size() != 3) {
      fail(row, fmt::format("\"{}\" leaves open which columns are x, y and z; name them in a line "
                            "before it, such as id,x,y,z",
                            shown(row.text)));
    }
    std::vector<TextItem> items(numbers.back() + 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      items[numbers[axis]].attribute = kAxes[axis].first;
    }
    return items;
  }

  /// Refuses rows such as "512999,314,5403002,956,250,001", whose commas separate and mark
  /// decimals. A second field of a pair that begins with 0 shows it: digits after a decimal comma
  /// may begin so, whole numbers do not.
  void refuse_split_decimals() const {
    for (const LayoutLine& row : sample_) {
      if (has_char(row.text, '.') || has_char(row.text, ';')) return;
      const Fields fields = fields_of(row.text, ',');
      if (fields.size() < 6 || fields.size() % 2 != 0) return;
      for (std::size_t i = 1; i < fields.size(); i += 2) {
        if (fields[i].size() < 2 || !fields[i].starts_with('0')) continue;
        fail(row, fmt::format("\"{}\": commas separate columns and mark decimals; write decimal "
                              "points, or semicolons between the columns",
                              shown(row.text)));
      }
    }
  }

  /// Refuses points whose first column numbers them, before x, y and z.
  void refuse_running_number() const {
    constexpr std::size_t kMinLines = 3;
    double first = 0.0, first_y = 0.0;
    bool has_other_y = false;
    if (sample_.size() < kMinLines) return;
    for (std::size_t i = 0; i < sample_.size(); ++i) {
      const Fields fields = fields_of(sample_[i].text, layout_.separator);
      if (fields.size() < 4) return;
      const auto number = table_number(fields[0]);
      const auto y = table_number(fields[1]);
      if (!number || !y || !table_number(fields[2]) || !table_number(fields[3])) return;
      if (i == 0) first = *number, first_y = *y;
      if (*number != first + static_cast<double>(i)) return;
      has_other_y = has_other_y || *y != first_y;
    }
    if (!has_other_y) return;  // the points are the first row of a raster
    fail(sample_.front(),
         fmt::format("\"{}\": the first column counts the points; name the columns "
                     "in a line before it, such as id,x,y,z",
                     shown(sample_.front().text)));
  }

  void refuse_impossible_height(const LayoutLine& row, const Fields& fields) const {
    constexpr double kMaxHeight = 30'000.0;  // the highest mountain in feet
    const auto item = std::ranges::find(layout_.items, PointAttribute::kZ, &TextItem::attribute);
    const auto column = static_cast<std::size_t>(item - layout_.items.begin());
    if (column >= fields.size()) return;
    const auto z = table_number(fields[column]);
    if (!z || !(std::abs(*z) > kMaxHeight)) return;
    fail(row, fmt::format("column {} as z is {}, no height; name the columns in a line before it, "
                          "such as id,x,y,z, and write decimal points where commas separate",
                          column + 1, fields[column]));
  }

  /// Drops the items behind the last one that is kept, as rows need not have them.
  void drop_trailing_items() {
    while (!layout_.items.empty() && !layout_.items.back().attribute) layout_.items.pop_back();
  }

  std::string_view text_;
  const std::string& path_;
  TextLayout layout_;
  std::optional<ColumnNames> columns_;
  std::vector<LayoutLine> sample_;  ///< the first rows of points
};

}  // namespace

TextLayout find_text_layout(std::string_view text, const std::string& path) {
  return LayoutFinder(text, path).find();
}

}  // namespace ridgeline::io
