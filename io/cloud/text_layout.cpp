// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/text_layout.h"

#include "io/error.h"
#include "io/text/table_row.h"
#include "io/text/text.h"
#include "io/text/utf8.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace ridgeline::io {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::array kAxes{std::pair{PointAttribute::kX, "x"}, std::pair{PointAttribute::kY, "y"},
                           std::pair{PointAttribute::kZ, "z"}};

struct PointRow {
  std::string_view text;
  std::uint64_t number = 0;
  std::size_t offset = 0;
};

Fields fields_of(std::string_view row, char separator) {
  Fields fields;
  TextFields walker(row, separator);
  while (const auto field = walker.next()) fields.push_back(*field);
  return fields;
}

bool is_table_number(std::string_view field) { return table_number(field).has_value(); }

bool begins_with_numbers(std::span<const std::string_view> fields, std::size_t n) {
  return fields.size() >= n && std::ranges::all_of(fields.first(n), is_table_number);
}

/// The separator of a row of points. Commas are decimal marks if blanks separate three numbers.
char separator_of_points(std::string_view row) {
  const char separator = separator_of(row);
  const bool is_by_blanks = separator == ',' && begins_with_numbers(fields_of(row, kBlanks), 3);
  return is_by_blanks ? kBlanks : separator;
}

/// The contents of a line of column names.
struct ColumnNames {
  std::uint64_t line = 0;
  Fields names;
  std::vector<TextItem> items;

  [[nodiscard]] auto count(PointAttribute attribute) const {
    return std::ranges::count(items, attribute, &TextItem::attribute);
  }
};

/// The columns that a line names, commented out or not; std::nullopt if x, y and z are not among
/// them.
std::optional<ColumnNames> column_names(const PointRow& line) {
  std::string_view text = line.text;
  text.remove_prefix(std::min(text.find_first_not_of("#/%!; \t"), text.size()));
  ColumnNames columns{
      .line = line.number, .names = fields_of(text, separator_of(text)), .items = {}};
  for (const std::string_view name : columns.names)
    columns.items.push_back({.attribute = attribute_of_column(name)});
  for (const auto& [axis, letter] : kAxes) {
    if (columns.count(axis) > 0) continue;
    for (std::size_t i = 0; i < columns.items.size(); ++i) {
      std::optional<PointAttribute>& attribute = columns.items[i].attribute;
      if (!attribute && column_name(columns.names[i]) == letter) attribute = axis;
    }
    if (columns.count(axis) == 0) return std::nullopt;
  }
  return columns;
}

class LayoutFinder {
 public:
  LayoutFinder(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  TextLayout find() {
    next_offset_ = text_.size() - without_byte_order_mark(text_).size();
    find_first_point();
    if (!columns_) layout_.items = {{kAxes[0].first}, {kAxes[1].first}, {kAxes[2].first}};
    if (columns_) layout_.items = columns_->items;
    if (!first_) {
      layout_.offset = text_.size();
      return layout_;
    }
    layout_.offset = first_->offset;
    layout_.first_line = first_->number;
    layout_.separator = separator_of_points(first_->text);
    const Fields fields = fields_of(first_->text, layout_.separator);
    const bool is_plain = first_->text.find('"') == std::string_view::npos &&
                          std::ranges::all_of(fields, [](std::string_view field) {
                            return field.find(',') == std::string_view::npos;
                          });
    if (!columns_ && is_plain) layout_.separator = kAnySeparator;
    if (columns_) {
      check_named_columns(fields);
    } else {
      check_columns_by_place(fields);
    }
    while (!layout_.items.empty() && !layout_.items.back().attribute) layout_.items.pop_back();
    return layout_;
  }

 private:
  [[noreturn]] void fail(const PointRow& line, const std::string& message) const {
    throw IoError(path_, fmt::format("line {}: {}", line.number, message));
  }

  std::optional<PointRow> next() {
    if (next_offset_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', next_offset_), text_.size());
    PointRow line{text_.substr(next_offset_, end - next_offset_), ++number_, next_offset_};
    next_offset_ = end + 1;
    return line;
  }

  /// Skips comments, "sep=", one point count and column names.
  void find_first_point() {
    bool is_counted = false;
    while (const auto line = next()) {
      if (auto columns = column_names(*line)) {
        columns_ = std::move(columns);
        continue;
      }
      const std::string_view row = trimmed(line->text);
      if (!is_text_row(row) || lower_case(row.substr(0, 4)) == "sep=") continue;
      const bool is_count = row.find_first_not_of("0123456789") == std::string_view::npos;
      if (is_count && !is_counted) {
        is_counted = true;
        continue;
      }
      first_ = line;
      return;
    }
  }

  void check_named_columns(const Fields& fields) {
    const ColumnNames& columns = *columns_;
    for (const auto& [axis, letter] : kAxes) {
      if (columns.count(axis) == 1) continue;
      throw IoError(
          path_,
          fmt::format("line {}: {} columns could be {}: {}; name only one of them {}", columns.line,
                      columns.count(axis), letter, fmt::join(columns.names, ", "), letter));
    }
    // a name may then belong to a field other than the one at its position
    const auto last = std::ranges::find_if(fields.rbegin(), fields.rend(),
                                           [](std::string_view field) { return !field.empty(); });
    if (const auto n = fields.rend() - last; n > std::ssize(columns.names)) {
      fail(*first_, fmt::format("has {} columns but line {} names {}; name every column, and write "
                                "decimal points where commas separate",
                                n, columns.line, columns.names.size()));
    }
    for (std::size_t i = 0; i < std::min(fields.size(), layout_.items.size()); ++i) {
      std::optional<PointAttribute>& attribute = layout_.items[i].attribute;
      const bool is_text = attribute && *attribute > PointAttribute::kZ && !fields[i].empty() &&
                           !is_table_number(fields[i]);
      if (is_text) attribute.reset();  // the column holds text, such as names of classes
    }
  }

  void check_columns_by_place(const Fields& fields) {
    constexpr double kMaxHeight = 30'000.0;  // the highest mountain in feet
    constexpr std::size_t kShown = 60;
    if (!begins_with_numbers(fields, std::min<std::size_t>(fields.size(), 3))) {
      fail(*first_,
           fmt::format(
               "\"{}\": the columns of x, y and z are ambiguous; name them in a preceding line, "
               "such as id,x,y,z, and write numbers without marks other than the decimal mark",
               trimmed(first_->text).substr(0, kShown)));
    }
    if (counts_points()) {
      fail(*first_, fmt::format("\"{}\": the first column appears to be a point number; name the "
                                "columns in a preceding line, such as id,x,y,z",
                                trimmed(first_->text).substr(0, kShown)));
    }
    if (fields.size() >= 3 && std::abs(*table_number(fields[2])) > kMaxHeight) {
      fail(*first_, fmt::format("column 3 as z is {}, no height; name the columns in a line before "
                                "it, such as id,x,y,z, and write decimal points where commas "
                                "separate",
                                fields[2]));
    }
  }

  /// Whether the first column numbers the points, before x, y and z. Points that all have the same
  /// y are the first row of a raster.
  bool counts_points() {
    constexpr std::size_t kMinRows = 3, kMaxRows = 50;
    std::vector<Fields> rows;
    for (std::optional<PointRow> line = first_; line && rows.size() < kMaxRows; line = next()) {
      if (!is_text_row(line->text)) continue;
      rows.push_back(fields_of(line->text, layout_.separator));
      if (!begins_with_numbers(rows.back(), 4)) return false;
      const double number = *table_number(rows.back()[0]);
      if (number != *table_number(rows[0][0]) + static_cast<double>(rows.size() - 1)) return false;
    }
    const auto has_other_y = [&](const Fields& row) {
      return *table_number(row[1]) != *table_number(rows[0][1]);
    };
    return rows.size() >= kMinRows && std::ranges::any_of(rows, has_other_y);
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t next_offset_ = 0;
  std::uint64_t number_ = 0;  ///< number of the line that next() returned last
  TextLayout layout_;
  std::optional<ColumnNames> columns_;
  std::optional<PointRow> first_;  ///< the first point
};

}  // namespace

TextLayout find_text_layout(std::string_view text, const std::string& path) {
  return LayoutFinder(text, path).find();
}

}  // namespace ridgeline::io
