// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/binary_table.h"

#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ridgeline::io {

namespace {

class BinaryTableSource : public CloudSource {
 public:
  BinaryTableSource(BinaryTable table, CloudFileInfo file_info)
      : CloudSource(std::move(file_info)), table_(std::move(table)) {}

  [[nodiscard]] std::size_t n_blocks() const override {
    return (info().n_points + kBlockSize - 1) / kBlockSize;
  }

  [[nodiscard]] bool is_light() const override {
    return !std::holds_alternative<std::vector<std::byte>>(table_.storage);
  }

  void release_blocks(std::size_t first, std::size_t count) const override {
    if (!std::holds_alternative<MappedFile>(table_.storage)) return;
    const std::size_t row_size = table_.columns.front().stride;  // a mapped table is row-wise
    const std::size_t begin = std::min(first * kBlockSize * row_size, table_.bytes.size());
    const std::size_t size = std::min(count * kBlockSize * row_size, table_.bytes.size() - begin);
    MappedFile::release(table_.bytes.subspan(begin, size));
  }

  void decode_block(std::size_t block,
                    const LocalFromFile& local_from_file,
                    std::vector<CloudPoint>& points) const override {
    const std::uint64_t first = block * kBlockSize;
    points.assign(std::min<std::uint64_t>(kBlockSize, info().n_points - first), CloudPoint{});
    for (const TableColumn& column : table_.columns) {
      const std::byte* value = table_.bytes.data() + column.offset + first * column.stride;
      for (CloudPoint& point : points) {
        set_attribute(column.attribute, load_scalar(value, column.type, table_.is_big_endian),
                      local_from_file, point);
        value += column.stride;
      }
    }
  }

 private:
  static constexpr std::size_t kBlockSize = 16384;

  BinaryTable table_;
};

/// Whether the column's values in `n_rows` rows lie within `n_bytes`. The claimed number of rows
/// may be anything, so the check divides rather than multiplies.
bool fits(const TableColumn& column, std::uint64_t n_rows, std::uint64_t n_bytes) {
  const std::uint64_t size = size_of(column.type);
  if (n_rows == 0) return true;
  if (column.offset > n_bytes || n_bytes - column.offset < size) return false;
  return (n_rows - 1) <= (n_bytes - column.offset - size) / column.stride;
}

}  // namespace

void check_coordinates(std::span<const PointAttribute> attributes, const std::string& path) {
  constexpr std::array kCoordinates{std::pair{PointAttribute::kX, 'x'},
                                    std::pair{PointAttribute::kY, 'y'},
                                    std::pair{PointAttribute::kZ, 'z'}};
  for (const auto& [attribute, name] : kCoordinates) {
    if (std::ranges::find(attributes, attribute) == attributes.end()) {
      throw IoError(path, fmt::format("has no column {}; x, y and z are needed", name));
    }
  }
}

std::unique_ptr<CloudSource> open_binary_table(BinaryTable table, CloudFileInfo info) {
  std::vector<PointAttribute> attributes;
  for (const TableColumn& column : table.columns) {
    attributes.push_back(column.attribute);
    if (!fits(column, info.n_points, table.bytes.size())) {
      throw IoError(info.path, fmt::format("declares {} points but holds only {} bytes of data",
                                           info.n_points, table.bytes.size()));
    }
    if (column.attribute <= PointAttribute::kZ && column.type == ScalarType::kFloat32) {
      info.has_float_coordinates = true;
    }
  }
  check_coordinates(attributes, info.path);
  return std::make_unique<BinaryTableSource>(std::move(table), std::move(info));
}

}  // namespace ridgeline::io
