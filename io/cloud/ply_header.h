// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/scalar_type.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::kFloat32;
  /// Type of the count that precedes the numbers of a list; unset for a single number.
  std::optional<ScalarType> list_count_type{};
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes per row; std::nullopt if a list makes the size of rows vary.
  [[nodiscard]] std::optional<std::uint64_t> row_size() const;
};

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;  ///< in file order
  std::size_t data_offset = 0;
  std::uint64_t data_line = 0;  ///< number of the last header line, from 1
};

/// Reads the header of a PLY file. Throws IoError with a message "line N: ...".
/// Source: G. Turk, The PLY Polygon File Format, 1994.
PlyHeader read_ply_header(std::span<const std::byte> file, const std::string& path);

}  // namespace ridgeline::io
