// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"
#include "io/cloud/laz/laszip_record.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::io::laz {

/// A run of records that is decoded independently.
struct Chunk {
  std::uint64_t offset;  ///< byte offset in the file
  std::uint64_t n_bytes;
  std::uint64_t first_record;
  std::uint32_t n_points;
};

/// Bytes of the field before the first chunk that states the position of the chunk table.
inline constexpr std::size_t kChunkTableOffsetSize = 8;

/// Maximum number of points of a chunk, which bounds the cost of a damaged count. LASzip's own
/// chunks have 50 000 points, those of COPC up to about 100 000.
inline constexpr std::uint32_t kMaxChunkPoints = 2'000'000;
// Maximum size of the decoded records of a chunk.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{64} << 20;

/// Whether `n_bytes` can hold `n_records`. Even a record that repeats its predecessor takes a
/// fraction of a bit: with all models at their most skewed, about 1000 records fit into a byte.
inline bool may_hold(std::uint64_t n_bytes, std::uint64_t n_records) {
  constexpr std::uint64_t kMaxRecordsPerByte = 4096;
  return n_records / kMaxRecordsPerByte <= n_bytes;
}

/// Reads the table at the end of a chunked file. The chunks returned cover all points stated in the
/// header, follow one another inside the file and do not exceed the limits above.
/// Throws CodecError with the reason if there is no such table.
std::vector<Chunk> read_chunk_table(std::span<const std::byte> file,
                                    const LasHeader& header,
                                    const LaszipRecord& laszip);

}  // namespace ridgeline::io::laz
