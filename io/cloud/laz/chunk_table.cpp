// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/chunk_table.h"

#include "io/cloud/bytes.h"
#include "io/cloud/laz/integer_decompressor.h"

#include <fmt/format.h>

#include <algorithm>

namespace ridgeline::io::laz {
namespace {

constexpr std::size_t kTableHeaderSize = 8;  // version and number of chunks

std::uint64_t table_offset(std::span<const std::byte> file, const LasHeader& header) {
  if (file.size() - header.point_offset < kChunkTableOffsetSize) {
    throw CodecError("the file ends before the position of the chunk table");
  }
  auto offset = load<std::int64_t>(&file[header.point_offset]);
  if (offset == -1) offset = load<std::int64_t>(&file[file.size() - kChunkTableOffsetSize]);
  const std::uint64_t first = header.point_offset + kChunkTableOffsetSize;
  if (offset == 0 || static_cast<std::uint64_t>(offset) == header.point_offset) {
    throw CodecError("the writer did not store the chunk table");
  }
  if (offset < 0 || static_cast<std::uint64_t>(offset) < first ||
      static_cast<std::uint64_t>(offset) > file.size() - kTableHeaderSize) {
    throw CodecError(
        fmt::format("the chunk table should start at byte {} of {}", offset, file.size()));
  }
  return static_cast<std::uint64_t>(offset);
}

// Every chunk holds at least one raw record, so the total size of the chunks limits the number of
// chunks that is accepted.
void check_count(std::uint64_t n_chunks,
                 std::uint64_t n_bytes,
                 const LasHeader& header,
                 const LaszipRecord& laszip) {
  if (n_chunks > n_bytes / header.record_length) {
    throw CodecError(fmt::format("the chunk table lists {} chunks in {} bytes", n_chunks, n_bytes));
  }
  if (laszip.has_variable_chunks()) return;
  const std::uint64_t size = laszip.chunk_size;
  const std::uint64_t expected = header.n_points / size + (header.n_points % size != 0 ? 1 : 0);
  if (n_chunks != expected) {
    throw CodecError(
        fmt::format("the chunk table lists {} chunks; {} points in chunks of {} need {}", n_chunks,
                    header.n_points, size, expected));
  }
}

void check_size(const Chunk& chunk, std::size_t index, std::uint64_t end, const LasHeader& header) {
  if (chunk.n_bytes == 0 || chunk.n_bytes > end - chunk.offset) {
    throw CodecError(fmt::format("chunk {} should have {} bytes from byte {} of {}", index,
                                 chunk.n_bytes, chunk.offset, end));
  }
  if (chunk.n_points > header.n_points - chunk.first_record) {
    throw CodecError(fmt::format("chunk {} should hold {} points, but only {} are left of {}",
                                 index, chunk.n_points, header.n_points - chunk.first_record,
                                 header.n_points));
  }
  if (!may_hold(chunk.n_bytes, chunk.n_points)) {
    throw CodecError(fmt::format("chunk {} should hold {} points, but its {} bytes cannot", index,
                                 chunk.n_points, chunk.n_bytes));
  }
  if (chunk.n_points > kMaxChunkPoints ||
      std::uint64_t{chunk.n_points} * header.record_length > kMaxChunkBytes) {
    throw CodecError(fmt::format(
        "chunk {} should hold {} points of {} bytes; the limits are {} points and {} bytes", index,
        chunk.n_points, header.record_length, kMaxChunkPoints, kMaxChunkBytes));
  }
}

}  // namespace

std::vector<Chunk> read_chunk_table(std::span<const std::byte> file,
                                    const LasHeader& header,
                                    const LaszipRecord& laszip) {
  constexpr unsigned kPointContext = 0;
  constexpr unsigned kByteContext = 1;
  const std::uint64_t table = table_offset(file, header);
  const auto version = load<std::uint32_t>(&file[table]);
  if (version != 0) throw CodecError(fmt::format("the chunk table has version {}, not 0", version));
  const auto n_chunks = load<std::uint32_t>(&file[table + 4]);
  Chunk chunk{};
  chunk.offset = header.point_offset + kChunkTableOffsetSize;
  check_count(n_chunks, table - chunk.offset, header, laszip);

  std::vector<Chunk> chunks;
  if (n_chunks > 0) {
    ArithmeticDecoder decoder(ByteStream(file.subspan(table + kTableHeaderSize)));
    IntegerDecompressor numbers(32, 2);
    for (std::size_t i = 0; i < n_chunks; ++i) {
      if (laszip.has_variable_chunks()) {
        chunk.n_points = static_cast<std::uint32_t>(
            numbers.decode(decoder, static_cast<std::int32_t>(chunk.n_points), kPointContext));
      } else {
        chunk.n_points = static_cast<std::uint32_t>(
            std::min<std::uint64_t>(laszip.chunk_size, header.n_points - chunk.first_record));
      }
      chunk.n_bytes = static_cast<std::uint32_t>(
          numbers.decode(decoder, static_cast<std::int32_t>(chunk.n_bytes), kByteContext));
      check_size(chunk, i, table, header);
      chunks.push_back(chunk);
      chunk.offset += chunk.n_bytes;
      chunk.first_record += chunk.n_points;
    }
  }
  if (chunk.first_record != header.n_points) {
    throw CodecError(fmt::format("the chunks hold {} points, but the header has {}",
                                 chunk.first_record, header.n_points));
  }
  return chunks;
}

}  // namespace ridgeline::io::laz
