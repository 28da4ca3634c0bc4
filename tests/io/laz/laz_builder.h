// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/laszip_record.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace ridgeline::io::laz {

using FileBytes = std::vector<std::byte>;

struct ChunkSize {
  std::uint32_t n_points, n_bytes;
};

/// The table behind the chunks, with the numbers of points of chunks of varying size.
FileBytes encode_chunk_table(std::span<const ChunkSize> chunks, bool has_variable_chunks);

/// Overwrites bytes of a file by letters.
void put_text(FileBytes& file, std::size_t offset, std::string_view text);

/// Appends a little-endian value.
template <typename T>
void append(FileBytes& file, T value) {
  const auto* const bytes = reinterpret_cast<const std::byte*>(&value);
  file.insert(file.end(), bytes, bytes + sizeof(T));
}

/// Small LAZ files for tests: point format 0, every chunk given by its bytes.
struct LazBuilder {
  struct BuiltChunk {
    FileBytes bytes;
    std::uint32_t n_points;
  };
  enum class Table { kBehindChunks, kAtEndOfFile, kMissing, kZero };

  std::uint16_t compressor = 2;
  std::uint16_t coder = 0;
  std::uint32_t chunk_size = 1;
  std::vector<Item> items{{ItemType::kPoint10, 20, 2}};
  std::uint32_t n_points = 0;
  std::vector<BuiltChunk> chunks;
  Table table = Table::kBehindChunks;

  /// Adds a chunk of one point with these raw coordinates.
  void add_single_point(std::int32_t x, std::int32_t y, std::int32_t z);

  [[nodiscard]] FileBytes build() const;
};

/// Overwrites a little-endian value in a file.
template <typename T>
void put(FileBytes& file, std::size_t offset, T value) {
  const auto* const bytes = reinterpret_cast<const std::byte*>(&value);
  std::copy(bytes, bytes + sizeof(T), file.begin() + static_cast<std::ptrdiff_t>(offset));
}

}  // namespace ridgeline::io::laz
