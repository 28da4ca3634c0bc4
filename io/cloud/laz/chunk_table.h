// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"
#include "io/cloud/laz/laszip_record.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::io::laz {

/// A run of records that is decoded on its own.
struct Chunk {
  std::uint64_t offset;  ///< byte of the file at which it begins
  std::uint64_t n_bytes;
  std::uint64_t first_record;
  std::uint32_t n_points;
};

/// Bytes of the table's position, which stands before the first chunk.
inline constexpr std::size_t kChunkTableOffsetSize = 8;

/// Points of the largest chunk that is decoded, which bounds what a damaged count may cost.
/// LASzip's own chunks have 50 000 points, those of COPC up to about 100 000.
inline constexpr std::uint32_t kMaxChunkPoints = 2'000'000;
// Bytes of the decoded records of the largest chunk that is decoded.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{64} << 20;

/// Whether `n_bytes` can hold `n_records`. Even a record that repeats its predecessor takes a share
/// of a bit: with all models at their most skewed, about 1000 records fit a byte.
inline bool may_hold(std::uint64_t n_bytes, std::uint64_t n_records) {
  constexpr std::uint64_t kMaxRecordsPerByte = 4096;
  return n_records / kMaxRecordsPerByte <= n_bytes;
}

/// Reads the table at the end of a chunked file. The chunks cover all points of the header, lie one
/// behind the other inside the file, and none is larger than the limits above.
/// Throws CodecError with the reason if there is no such table.
std::vector<Chunk> read_chunk_table(std::span<const std::byte> file,
                                    const LasHeader& header,
                                    const LaszipRecord& laszip);

}  // namespace ridgeline::io::laz
