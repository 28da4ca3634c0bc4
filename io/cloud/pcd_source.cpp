// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/pcd_source.h"

#include "io/cloud/binary_table.h"
#include "io/cloud/bytes.h"
#include "io/cloud/header_lines.h"
#include "io/cloud/lzf.h"
#include "io/cloud/scalar_type.h"
#include "io/cloud/text_table.h"
#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::io {

namespace {

using Words = std::vector<std::string_view>;

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::kFloat32;
  std::uint64_t count = 1;  ///< number of values of this field per point

  [[nodiscard]] std::uint64_t size() const { return size_of(type) * count; }
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t n_points = 0;
  std::string data;  ///< "ascii", "binary" or "binary_compressed"
  std::size_t data_offset = 0;
  std::uint64_t data_line = 0;

  [[nodiscard]] std::uint64_t row_size() const {
    std::uint64_t size = 0;
    for (const PcdField& field : fields) size += field.size();
    return size;
  }
};

/// The words after each keyword of the header, up to and including DATA.
std::map<std::string, Words, std::less<>> read_entries(HeaderLines& lines) {
  std::map<std::string, Words, std::less<>> entries;
  while (!entries.contains("DATA")) {
    const Words words = lines.next();
    if (words.empty() || words.front().starts_with('#')) continue;
    entries[std::string(words.front())] = Words(words.begin() + 1, words.end());
  }
  return entries;
}

class PcdEntries {
 public:
  explicit PcdEntries(HeaderLines& lines) : lines_(lines), entries_(read_entries(lines)) {}

  [[nodiscard]] bool has(std::string_view key) const { return entries_.contains(key); }

  /// The words of an entry. Throws IoError unless there are exactly `n`, or at least one if `n` is
  /// 0.
  [[nodiscard]] const Words& words(std::string_view key, std::size_t n) const {
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) lines_.fail(fmt::format("the header has no {}", key));
    const std::size_t found = entry->second.size();
    if (n == 0 ? found == 0 : found != n) {
      lines_.fail(
          fmt::format("{} has {} entries; {} are needed", key, found, std::max<std::size_t>(n, 1)));
    }
    return entry->second;
  }

  [[nodiscard]] std::uint64_t count(std::string_view key) const {
    return lines_.parse_count(words(key, 1).front(), key);
  }

 private:
  HeaderLines& lines_;
  std::map<std::string, Words, std::less<>> entries_;
};

std::vector<PcdField> read_fields(const PcdEntries& entries, const HeaderLines& lines) {
  // Maximum number of values per point; each takes memory in the reader.
  constexpr std::uint64_t kMaxNumbers = 1U << 20U;
  std::uint64_t n_numbers = 0;
  const Words& names = entries.words("FIELDS", 0);
  const Words& sizes = entries.words("SIZE", names.size());
  const Words& types = entries.words("TYPE", names.size());
  std::vector<PcdField> fields;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto type =
        scalar_type_of_pcd_field(types[i].front(), lines.parse_count(sizes[i], "SIZE"));
    if (!type) {
      lines.fail(
          fmt::format("field {} has TYPE {} and SIZE {}; must be I, U or F of 1, 2, 4 or 8 "
                      "bytes",
                      names[i], types[i], sizes[i]));
    }
    PcdField field{.name = std::string(names[i]), .type = *type};
    if (entries.has("COUNT")) {
      field.count = lines.parse_count(entries.words("COUNT", names.size())[i], "COUNT");
    }
    if (field.count > kMaxNumbers - n_numbers) {
      lines.fail(fmt::format("field {} has COUNT {}; a point must have at most {} numbers",
                             names[i], field.count, kMaxNumbers));
    }
    n_numbers += field.count;
    fields.push_back(std::move(field));
  }
  return fields;
}

std::uint64_t read_point_count(const PcdEntries& entries, const HeaderLines& lines) {
  const std::uint64_t width = entries.count("WIDTH");
  const std::uint64_t height = entries.count("HEIGHT");
  const std::uint64_t n_points = entries.has("POINTS") ? entries.count("POINTS") : width * height;
  // The product of two arbitrary counts may wrap around, so they are compared by division.
  const bool agree =
      height == 0 ? n_points == 0 : n_points % height == 0 && n_points / height == width;
  if (!agree) {
    lines.fail(fmt::format("POINTS is {} but WIDTH x HEIGHT is {} x {}; they must agree", n_points,
                           width, height));
  }
  return n_points;
}

PcdHeader read_header(std::span<const std::byte> file, const std::string& path) {
  HeaderLines lines(file, path);
  const PcdEntries entries(lines);
  PcdHeader header{.fields = read_fields(entries, lines),
                   .n_points = read_point_count(entries, lines),
                   .data = std::string(entries.words("DATA", 1).front()),
                   .data_offset = lines.offset(),
                   .data_line = lines.line_number()};
  if (header.data != "ascii" && header.data != "binary" && header.data != "binary_compressed") {
    lines.fail(fmt::format("DATA is {}; must be ascii, binary or binary_compressed", header.data));
  }
  return header;
}

std::unique_ptr<CloudSource> open_ascii(MappedFile file,
                                        const PcdHeader& header,
                                        CloudFileInfo info) {
  TextTable table{.file = std::move(file),
                  .offset = header.data_offset,
                  .first_line = header.data_line + 1,
                  .items = {}};
  for (const PcdField& field : header.fields) {
    const auto attribute = attribute_of_column(field.name);
    for (std::uint64_t i = 0; i < field.count; ++i) {
      table.items.push_back({.attribute = i == 0 ? attribute : std::nullopt});
    }
  }
  return open_text_table(std::move(table), std::move(info), true);
}

/// The columns of a table that is stored row by row or, in packed files, field by field.
std::vector<TableColumn> lay_out(const PcdHeader& header, bool field_after_field) {
  std::vector<TableColumn> columns;
  std::size_t offset = 0;
  for (const PcdField& field : header.fields) {
    const auto attribute = attribute_of_column(field.name);
    if (attribute && field.count > 0) {
      columns.push_back({.attribute = *attribute,
                         .type = field.type,
                         .offset = offset,
                         .stride = field_after_field ? field.size() : header.row_size()});
    }
    offset += field.size() * (field_after_field ? header.n_points : 1);
  }
  return columns;
}

std::vector<std::byte> unpack(std::span<const std::byte> data,
                              const PcdHeader& header,
                              const std::string& path) {
  constexpr std::size_t kSizes = 8;
  constexpr std::uint64_t kAlwaysUnpacked_bytes = 64U << 20U;
  constexpr std::uint64_t kMaxGrowth = 10;
  if (data.size() < kSizes) throw IoError(path, "ends before the sizes of its packed data");
  const std::uint64_t packed_size = load<std::uint32_t>(data.data());
  const std::uint64_t unpacked_size = load<std::uint32_t>(data.data() + 4);
  if (packed_size > data.size() - kSizes) {
    throw IoError(path, fmt::format("declares {} bytes of packed data but has {}", packed_size,
                                    data.size() - kSizes));
  }
  const std::uint64_t row_size = header.row_size();
  if (row_size == 0 || unpacked_size % row_size != 0 ||
      unpacked_size / row_size != header.n_points) {
    throw IoError(
        path,
        fmt::format("the packed data unpack to {} bytes, but {} points of {} bytes are declared",
                    unpacked_size, header.n_points, row_size));
  }
  if (unpacked_size > kAlwaysUnpacked_bytes && unpacked_size / kMaxGrowth > packed_size) {
    throw IoError(path, fmt::format("{} bytes of packed data would grow to {} bytes; points shrink "
                                    "to a tenth at best, so the file is damaged",
                                    packed_size, unpacked_size));
  }
  auto unpacked = unpack_lzf(data.subspan(kSizes, packed_size), unpacked_size);
  if (!unpacked) throw IoError(path, "its packed data are damaged and cannot be unpacked by LZF");
  return std::move(*unpacked);
}

}  // namespace

std::unique_ptr<CloudSource> open_pcd(MappedFile file, const std::string& path) {
  const PcdHeader header = read_header(file.bytes(), path);
  CloudFileInfo info{.path = path, .format = "PCD, " + header.data, .n_points = header.n_points};
  if (header.data == "ascii") return open_ascii(std::move(file), header, std::move(info));

  const std::span<const std::byte> data = file.bytes().subspan(header.data_offset);
  BinaryTable table{.storage = std::vector<std::byte>{}};
  if (header.data == "binary") {
    table.columns = lay_out(header, false);
    table.bytes = data;
    table.storage = std::move(file);
  } else {
    std::vector<std::byte> unpacked = unpack(data, header, path);
    table.columns = lay_out(header, true);  // unpack() has checked the counts, so no size overflows
    table.bytes = unpacked;
    table.storage = std::move(unpacked);
  }
  return open_binary_table(std::move(table), std::move(info));
}

}  // namespace ridgeline::io
