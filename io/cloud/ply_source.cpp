// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/ply_source.h"

#include "io/cloud/binary_table.h"
#include "io/cloud/ply_header.h"
#include "io/cloud/text_table.h"
#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace ridgeline::io {

namespace {

using Bytes = std::span<const std::byte>;

/// Iterates over binary rows whose size varies because of lists.
class RowWalker {
 public:
  RowWalker(Bytes data, bool is_big_endian, std::string file_path)
      : rest_(data), is_big_endian_(is_big_endian), path_(std::move(file_path)) {}

  [[nodiscard]] Bytes rest() const { return rest_; }

  void skip(const PlyElement& element) {
    if (const auto row_size = element.row_size()) {
      const bool fits = *row_size == 0 || element.count <= rest_.size() / *row_size;
      if (!fits) fail(element);
      rest_ = rest_.subspan(*row_size * element.count);
      return;
    }
    // A list takes at least one byte, so a garbage count stops at the end of the file.
    for (std::uint64_t row = 0; row < element.count; ++row) {
      for (const PlyProperty& property : element.properties) take(property, element);
    }
  }

  /// The rows of `element` without their lists, so that all have the same size.
  std::vector<std::byte> copy_without_lists(const PlyElement& element) {
    std::vector<std::byte> rows;
    for (std::uint64_t row = 0; row < element.count; ++row) {
      for (const PlyProperty& property : element.properties) {
        const Bytes value = take(property, element);
        if (!property.list_count_type) rows.insert(rows.end(), value.begin(), value.end());
      }
    }
    return rows;
  }

 private:
  [[noreturn]] void fail(const PlyElement& element) const {
    throw IoError(
        path_, fmt::format("ends before the {} rows of element {}", element.count, element.name));
  }

  Bytes take(std::size_t size, const PlyElement& element) {
    if (size > rest_.size()) fail(element);
    const Bytes taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }

  Bytes take(const PlyProperty& property, const PlyElement& element) {
    const std::size_t size = size_of(property.type);
    if (!property.list_count_type) return take(size, element);
    const Bytes count_bytes = take(size_of(*property.list_count_type), element);
    const double count = load_scalar(count_bytes.data(), *property.list_count_type, is_big_endian_);
    const std::size_t n_fitting = rest_.size() / size;
    const bool fits = count >= 0.0 && count <= static_cast<double>(n_fitting);
    if (!fits) fail(element);
    return take(static_cast<std::size_t>(count) * size, element);
  }

  Bytes rest_;
  bool is_big_endian_;
  std::string path_;
};

/// The columns of a row without its lists.
std::vector<TableColumn> lay_out(const PlyElement& vertex) {
  std::vector<TableColumn> columns;
  std::size_t offset = 0;
  for (const PlyProperty& property : vertex.properties) {
    if (property.list_count_type) continue;
    if (const auto attribute = attribute_of_column(property.name)) {
      columns.push_back(
          {.attribute = *attribute, .type = property.type, .offset = offset, .stride = 0});
    }
    offset += size_of(property.type);
  }
  for (TableColumn& column : columns) column.stride = offset;
  return columns;
}

std::unique_ptr<CloudSource> open_ascii(MappedFile file,
                                        const PlyHeader& header,
                                        std::span<const PlyElement> before,
                                        const PlyElement& vertex,
                                        CloudFileInfo info) {
  TextTable table{.file = std::move(file),
                  .offset = header.data_offset,
                  .first_line = header.data_line + 1,
                  .items = {}};
  for (const PlyElement& element : before) {
    if (element.count > table.file.bytes().size()) {
      throw IoError(info.path, fmt::format("declares {} rows of element {} in {} bytes",
                                           element.count, element.name, table.file.bytes().size()));
    }
    table.n_skipped_rows += element.count;
  }
  for (const PlyProperty& property : vertex.properties) {
    const auto attribute = attribute_of_column(property.name);
    const bool is_list = property.list_count_type.has_value();
    table.items.push_back({.attribute = is_list ? std::nullopt : attribute, .is_list = is_list});
  }
  return open_text_table(std::move(table), std::move(info), true);
}

std::unique_ptr<CloudSource> open_binary(MappedFile file,
                                         const PlyHeader& header,
                                         std::span<const PlyElement> before,
                                         const PlyElement& vertex,
                                         CloudFileInfo info) {
  const bool is_big_endian = header.encoding == PlyEncoding::kBigEndian;
  RowWalker walker(file.bytes().subspan(header.data_offset), is_big_endian, info.path);
  for (const PlyElement& element : before) walker.skip(element);

  BinaryTable table{.storage = std::vector<std::byte>{},
                    .bytes = {},
                    .columns = lay_out(vertex),
                    .is_big_endian = is_big_endian};
  if (vertex.row_size()) {
    table.bytes = walker.rest();
    table.storage = std::move(file);
  } else {
    std::vector<std::byte> rows = walker.copy_without_lists(vertex);
    table.bytes = rows;
    table.storage = std::move(rows);
  }
  return open_binary_table(std::move(table), std::move(info));
}

}  // namespace

std::unique_ptr<CloudSource> open_ply(MappedFile file, const std::string& path) {
  const PlyHeader header = read_ply_header(file.bytes(), path);
  const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  if (vertex == header.elements.end()) throw IoError(path, "has no element vertex");
  const std::span<const PlyElement> before(header.elements.begin(), vertex);
  const bool is_ascii = header.encoding == PlyEncoding::kAscii;
  CloudFileInfo info{
      .path = path, .format = is_ascii ? "PLY, ascii" : "PLY, binary", .n_points = vertex->count};
  return is_ascii ? open_ascii(std::move(file), header, before, *vertex, std::move(info))
                  : open_binary(std::move(file), header, before, *vertex, std::move(info));
}

}  // namespace ridgeline::io
