// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io::laz {

/// How the records of a LAZ file are coded (LASzip specification, "The VLR"; numbers as stored).
enum class Compressor : std::uint16_t { kPointwise = 1, kPointwiseChunked = 2, kLayered = 3 };

enum class ItemType : std::uint16_t {
  kByte = 0,
  kPoint10 = 6,
  kGpsTime11 = 7,
  kRgb12 = 8,
  kWavePacket13 = 9,
  kPoint14 = 10,
  kRgb14 = 11,
  kRgbNir14 = 12,
  kWavePacket14 = 13,
  kByte14 = 14,
};

struct Item {
  ItemType type;
  std::uint16_t size;  ///< bytes in a record
  std::uint16_t version;
};

/// The LASzip record of a compressed file, checked: every item can be decoded, and together the
/// items are exactly the file's point record.
struct LaszipRecord {
  static constexpr std::uint32_t kVariableChunkSize = 0xFFFFFFFF;

  Compressor compressor = Compressor::kPointwiseChunked;
  /// Points per chunk; meaningless if there are no chunks.
  std::uint32_t chunk_size = kVariableChunkSize;
  std::uint16_t record_length = 0;
  std::vector<Item> items;

  [[nodiscard]] bool has_variable_chunks() const { return chunk_size == kVariableChunkSize; }
};

/// Reads VLR "laszip encoded" 22204.
/// Throws IoError if the record is missing or truncated, has an unknown compressor, coder, item
/// type or item version (named in the message), has items that do not make up the point format, or
/// has chunk size 0.
LaszipRecord read_laszip_record(std::span<const std::byte> file,
                                const LasHeader& header,
                                const std::string& path);

}  // namespace ridgeline::io::laz
