// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/text_table.h"

#include "io/cloud/binary_table.h"
#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace ridgeline::io {

namespace {

constexpr std::uint64_t kRowsPerBlock = 16384;
constexpr std::string_view kSeparators = " \t\r,;";

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

/// Empty at the end of the line.
std::string_view take_token(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kSeparators), line.size()));
  const std::string_view token = line.substr(0, line.find_first_of(kSeparators));
  line.remove_prefix(token.size());
  return token;
}

bool is_row(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kSeparators);
  if (first == std::string_view::npos) return false;
  line.remove_prefix(first);
  return !line.starts_with('#') && !line.starts_with("//");
}

/// Where a run of rows begins.
struct BlockStart {
  std::size_t offset;
  std::uint64_t line;
};

struct RowIndex {
  std::vector<BlockStart> starts;  ///< of every kRowsPerBlock-th row, and of what follows the last
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
    if (!is_row(take_line(rest)) || n_seen++ < table.n_skipped_rows) continue;
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
      if (is_row(line)) points.push_back(parse_row(line, line_number, local_from_file));
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
    for (const TextItem& item : table_.items) {
      const double value = take_number(line, line_number);
      if (item.attribute) set_attribute(*item.attribute, value, local_from_file, point);
      if (!item.is_list) continue;
      // a row that is shorter than its list says ends in an error
      constexpr double kLongestList = 1e6;
      const auto n = value > 0.0 ? std::lround(std::min(std::ceil(value), kLongestList)) : 0L;
      for (long i = 0; i < n; ++i) take_number(line, line_number);
    }
    return point;
  }

  double take_number(std::string_view& line, std::uint64_t line_number) const {
    constexpr std::size_t kShown = 40;
    std::string_view token = take_token(line);
    if (token.starts_with('+')) token.remove_prefix(1);  // from_chars takes no plus sign
    double value = 0.0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (token.empty() || error != std::errc{} || end != token.data() + token.size()) {
      throw IoError(info().path, token.empty()
                                     ? fmt::format("line {} has too few numbers; {} are needed",
                                                   line_number, table_.items.size())
                                     : fmt::format("line {}: \"{}\" is no number", line_number,
                                                   token.substr(0, kShown)));
    }
    return value;
  }

  TextTable table_;
  RowIndex index_;
};

}  // namespace

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
    throw IoError(info.path, fmt::format("claims {} points but has only {} lines of them",
                                         info.n_points, index.n_rows));
  }
  info.n_points = index.n_rows;
  return std::make_unique<TextTableSource>(std::move(table), std::move(index), std::move(info));
}

}  // namespace ridgeline::io
