// SPDX-License-Identifier: BSD-3-Clause
#include "tests/io/laz/laz_builder.h"

#include "tests/io/laz/arithmetic_encoder.h"

#include <string_view>

namespace ridgeline::io::laz {
namespace {

constexpr std::size_t kLasHeaderSize = 227;  // LAS 1.2
constexpr std::size_t kLasVlrHeaderSize = 54;

FileBytes header(std::uint32_t n_points, std::size_t laszip_size) {
  FileBytes file(kLasHeaderSize);
  put_text(file, 0, "LASF");
  put(file, 24, std::uint8_t{1});
  put(file, 25, std::uint8_t{2});
  put(file, 94, static_cast<std::uint16_t>(kLasHeaderSize));
  put(file, 96, static_cast<std::uint32_t>(kLasHeaderSize + kLasVlrHeaderSize + laszip_size));
  put(file, 100, std::uint32_t{1});
  put(file, 104, std::uint8_t{0x80});
  put(file, 105, std::uint16_t{20});
  put(file, 107, n_points);
  for (const std::size_t axis : {0U, 1U, 2U}) put(file, 131 + 8 * axis, 0.01);
  return file;
}

void append_laszip_record(FileBytes& file, const LazBuilder& builder) {
  const std::size_t vlr = file.size();
  file.resize(vlr + kLasVlrHeaderSize);
  put_text(file, vlr + 2, "laszip encoded");
  put(file, vlr + 18, std::uint16_t{22204});
  put(file, vlr + 20, static_cast<std::uint16_t>(34 + 6 * builder.items.size()));
  append(file, builder.compressor);
  append(file, builder.coder);
  append(file, std::uint32_t{0x00000302});  // version 2.3
  append(file, std::uint32_t{0});           // options
  append(file, builder.chunk_size);
  append(file, std::int64_t{-1});
  append(file, std::int64_t{-1});
  append(file, static_cast<std::uint16_t>(builder.items.size()));
  for (const Item& item : builder.items) {
    append(file, static_cast<std::uint16_t>(item.type));
    append(file, item.size);
    append(file, item.version);
  }
}

}  // namespace

FileBytes encode_chunk_table(std::span<const ChunkSize> chunks, bool has_variable_chunks) {
  ArithmeticEncoder encoder;
  IntegerCompressor numbers(32, 2);
  std::int32_t last_points = 0;
  std::int32_t last_bytes = 0;
  for (const auto& [n_points, n_bytes] : chunks) {
    if (has_variable_chunks) {
      numbers.encode(encoder, last_points, static_cast<std::int32_t>(n_points), 0);
      last_points = static_cast<std::int32_t>(n_points);
    }
    numbers.encode(encoder, last_bytes, static_cast<std::int32_t>(n_bytes), 1);
    last_bytes = static_cast<std::int32_t>(n_bytes);
  }
  FileBytes table;
  append(table, std::uint32_t{0});
  append(table, static_cast<std::uint32_t>(chunks.size()));
  const std::vector<std::byte> entries = encoder.finish();
  table.insert(table.end(), entries.begin(), entries.end());
  return table;
}

void put_text(FileBytes& file, std::size_t offset, std::string_view text) {
  for (const char letter : text) file[offset++] = static_cast<std::byte>(letter);
}

void LazBuilder::add_single_point(std::int32_t x, std::int32_t y, std::int32_t z) {
  FileBytes bytes;
  append(bytes, x);
  append(bytes, y);
  append(bytes, z);
  bytes.resize(24);  // the other 8 bytes of the record, then 4 that start the decoder
  chunks.push_back({bytes, 1});
  ++n_points;
}

FileBytes LazBuilder::build() const {
  FileBytes file = header(n_points, 34 + 6 * items.size());
  append_laszip_record(file, *this);
  const std::size_t point_offset = file.size();
  if (compressor != 1) append(file, std::int64_t{0});
  for (const BuiltChunk& chunk : chunks) {
    file.insert(file.end(), chunk.bytes.begin(), chunk.bytes.end());
  }
  if (compressor == 1) return file;
  const auto table_offset = static_cast<std::int64_t>(file.size());
  if (table == Table::kMissing) {
    put(file, point_offset, static_cast<std::int64_t>(point_offset));
    return file;
  }
  if (table == Table::kZero) return file;
  std::vector<ChunkSize> sizes;
  for (const BuiltChunk& chunk : chunks) {
    sizes.push_back({chunk.n_points, static_cast<std::uint32_t>(chunk.bytes.size())});
  }
  const FileBytes entries =
      encode_chunk_table(sizes, chunk_size == LaszipRecord::kVariableChunkSize);
  file.insert(file.end(), entries.begin(), entries.end());
  if (table == Table::kAtEndOfFile) append(file, table_offset);
  put(file, point_offset, table == Table::kAtEndOfFile ? std::int64_t{-1} : table_offset);
  return file;
}

}  // namespace ridgeline::io::laz
