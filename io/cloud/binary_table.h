// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/cloud/point_attribute.h"
#include "io/cloud/scalar_type.h"
#include "io/files/mapped_file.h"

#include <cstddef>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace ridgeline::io {

/// Where one attribute lies: the value of row i is at offset + i * stride.
struct TableColumn {
  PointAttribute attribute;
  ScalarType type;
  std::size_t offset;
  std::size_t stride;
};

/// Rows of numbers, row by row (PLY, PCD binary) or column by column (PCD binary_compressed).
struct BinaryTable {
  /// Owns `bytes`: the mapped file, or the numbers unpacked from it. With std::monostate, the
  /// caller keeps the bytes alive.
  std::variant<MappedFile, std::vector<std::byte>, std::monostate> storage;
  std::span<const std::byte> bytes{};
  std::vector<TableColumn> columns{};
  bool is_big_endian = false;
};

/// Opens `table` as a source with info.n_points rows.
/// Throws IoError if a coordinate column is missing or a column extends beyond the bytes.
std::unique_ptr<CloudSource> open_binary_table(BinaryTable table, CloudFileInfo info);

/// Checks that x, y and z are among the columns of a binary or text table.
/// Throws IoError, naming the missing one, if they are not.
void check_coordinates(std::span<const PointAttribute> attributes, const std::string& path);

}  // namespace ridgeline::io
