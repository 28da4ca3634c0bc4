// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/text_table.h"

#include "io/cloud/binary_table.h"
#include "io/error.h"
#include "io/text/table_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace ridgeline::io {

namespace {

constexpr std::uint64_t kRowsPerBlock = 16384;
constexpr std::string_view kBlankChars = " \t\r";

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
constexpr bool is_mark(char c) { return c == ',' || c == ';'; }
constexpr bool starts_number(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::string_view without_quotes(std::string_view field) {
  const std::size_t first = field.find_first_not_of(kBlankChars);
  if (first == std::string_view::npos) return {};
  field = field.substr(first, field.find_last_not_of(kBlankChars) + 1 - first);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
    field = field.substr(1, field.size() - 2);
  }
  return field;
}

/// Where a run of rows begins.
struct BlockStart {
  std::size_t offset;
  std::uint64_t line;
};

struct RowIndex {
  /// Start of every kRowsPerBlock-th row, and of whatever follows the last row.
  std::vector<BlockStart> starts;
  std::uint64_t n_rows = 0;
};

RowIndex index_rows(const TextTable& table, std::uint64_t limit) {
  RowIndex index;
  const auto bytes = table.file.bytes();
  const std::string_view whole(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::string_view rest = whole.substr(table.offset);
  std::uint64_t n_seen = 0;
  std::uint64_t line_number = table.first_line;
  for (; !rest.empty() && index.n_rows < limit; ++line_number) {
    const std::size_t offset = whole.size() - rest.size();
    if (!is_text_row(take_line(rest)) || n_seen++ < table.n_skipped_rows) continue;
    if (index.n_rows++ % kRowsPerBlock == 0) index.starts.push_back({offset, line_number});
  }
  index.starts.push_back({whole.size() - rest.size(), line_number});
  return index;
}

class TextTableSource : public CloudSource {
 public:
  TextTableSource(TextTable table, RowIndex index, CloudFileInfo file_info)
      : CloudSource(std::move(file_info)), table_(std::move(table)), index_(std::move(index)) {}

  [[nodiscard]] std::size_t n_blocks() const override { return index_.starts.size() - 1; }

  void release_blocks(std::size_t first, std::size_t count) const override {
    MappedFile::release(bytes_of(first, count));
  }

  void decode_block(std::size_t block,
                    const LocalFromFile& local_from_file,
                    std::vector<CloudPoint>& points) const override {
    const BlockStart& start = index_.starts[block];
    const auto bytes = bytes_of(block, 1);
    std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    points.clear();
    for (std::uint64_t line_number = start.line; !rest.empty(); ++line_number) {
      const std::string_view line = take_line(rest);
      if (is_text_row(line)) points.push_back(parse_row(line, line_number, local_from_file));
    }
  }

 private:
  [[nodiscard]] std::span<const std::byte> bytes_of(std::size_t block, std::size_t count) const {
    const std::size_t begin = index_.starts[block].offset;
    return table_.file.bytes().subspan(begin, index_.starts[block + count].offset - begin);
  }

  [[nodiscard]] CloudPoint parse_row(std::string_view line,
                                     std::uint64_t line_number,
                                     const LocalFromFile& local_from_file) const {
    CloudPoint point{};
    TextFields fields(line, table_.separator);
    for (const TextItem& item : table_.items) {
      const std::string_view field = take_field(fields, line_number);
      if (!item.attribute && !item.is_list) continue;
      const bool is_left_open =
          field.empty() && item.attribute && *item.attribute > PointAttribute::kZ;
      if (is_left_open) continue;
      const double value = number(field, line_number);
      if (item.attribute) set_attribute(*item.attribute, value, local_from_file, point);
      if (!item.is_list) continue;
      // A row that is shorter than the stated length of its list causes an error below.
      constexpr double kMaxListLength = 1e6;
      const auto n = value > 0.0 ? std::lround(std::min(std::ceil(value), kMaxListLength)) : 0L;
      for (long i = 0; i < n; ++i) (void)number(take_field(fields, line_number), line_number);
    }
    return point;
  }

  std::string_view take_field(TextFields& fields, std::uint64_t line_number) const {
    if (const auto field = fields.next()) return *field;
    throw IoError(info().path, fmt::format("line {} has too few numbers; {} are needed",
                                           line_number, table_.items.size()));
  }

  [[nodiscard]] double number(std::string_view field, std::uint64_t line_number) const {
    constexpr std::size_t kShown = 40;
    if (const auto value = table_number(field)) return *value;
    const bool has_marks = field.find(',') != std::string_view::npos &&
                           field.find_first_not_of("+-0123456789.,") == std::string_view::npos;
    throw IoError(
        info().path,
        fmt::format("line {}: \"{}\" is not a number{}", line_number, field.substr(0, kShown),
                    has_marks ? "; write it without thousands separators" : ""));
  }

  TextTable table_;
  RowIndex index_;
};

}  // namespace

std::optional<std::string_view> TextFields::next_between_marks() {
  if (has_ended_) return std::nullopt;
  std::size_t end = 0;
  const std::size_t first = rest_.find_first_not_of(kBlankChars);
  if (separator_ != '\t' && first != std::string_view::npos && rest_[first] == '"') {
    // A quoted field may hold the separator.
    end = std::min(rest_.find('"', first + 1), rest_.size());
  }
  end = rest_.find(separator_, end);
  const std::string_view field = rest_.substr(0, end);
  has_ended_ = end == std::string_view::npos;
  rest_.remove_prefix(has_ended_ ? rest_.size() : end + 1);
  return without_quotes(field);
}

std::optional<std::string_view> TextFields::next() {
  if (separator_ != kAnySeparator && separator_ != kBlanks) return next_between_marks();
  const auto separates = [&](char c) {
    return is_blank(c) || (separator_ == kAnySeparator && is_mark(c));
  };
  const std::size_t most_marks = is_first_ ? 0 : 1;
  std::size_t n_marks = 0;
  std::size_t start = 0;
  is_first_ = false;
  for (; start < rest_.size() && separates(rest_[start]); ++start) {
    if (is_mark(rest_[start]) && ++n_marks > most_marks) {
      break;  // an empty field, which must not be skipped silently
    }
  }
  if (start == rest_.size()) return std::nullopt;
  rest_.remove_prefix(start);
  const std::size_t end =
      static_cast<std::size_t>(std::ranges::find_if(rest_, separates) - rest_.begin());
  const std::string_view field = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return field.starts_with('"') ? without_quotes(field) : field;
}

bool is_text_row(std::string_view line) {
  const auto first = std::ranges::find_if_not(line, is_blank);
  if (first == line.end()) return false;
  if (starts_number(*first)) return true;
  line.remove_prefix(static_cast<std::size_t>(first - line.begin()));
  if (line.front() == '#' || line.front() == '%' || line.front() == '!') return false;
  if (line.starts_with("//")) return false;
  const auto word =
      std::ranges::find_if_not(line, [](char c) { return is_blank(c) || is_mark(c); });
  if (word == line.end()) return false;
  // A line "; note" is a comment, but a leading ";" may also mean an empty field before a number.
  return line.front() != ';' || starts_number(*word) || *word == '"';
}

std::unique_ptr<CloudSource> open_text_table(TextTable table,
                                             CloudFileInfo info,
                                             bool has_row_count) {
  std::vector<PointAttribute> attributes;
  for (const TextItem& item : table.items) {
    if (item.attribute) attributes.push_back(*item.attribute);
  }
  check_coordinates(attributes, info.path);
  constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
  RowIndex index = index_rows(table, has_row_count ? info.n_points : kAll);
  if (has_row_count && index.n_rows != info.n_points) {
    throw IoError(info.path, fmt::format("declares {} points but has only {} lines of points",
                                         info.n_points, index.n_rows));
  }
  info.n_points = index.n_rows;
  return std::make_unique<TextTableSource>(std::move(table), std::move(index), std::move(info));
}

}  // namespace ridgeline::io
