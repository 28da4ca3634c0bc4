// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/laszip_record.h"
#include "io/cloud/laz/record_decoder.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io::laz {

/// Records that can only be decoded sequentially from the first: those of a file without chunks or
/// without a usable chunk table. Returns them in blocks, to any thread; the latest blocks are kept
/// for requests that arrive slightly out of order.
class SequentialRecords {
 public:
  static constexpr std::size_t kBlocksKept = 32;  ///< twice the number that a reader decodes ahead

  /// `bytes` begin with the first chunk and may extend beyond the last. All blocks but the last
  /// have `block_size` records.
  SequentialRecords(std::span<const std::byte> bytes,
                    LaszipRecord laszip,
                    std::uint64_t n_records,
                    std::string path,
                    std::uint32_t block_size = 16384);

  [[nodiscard]] std::size_t n_blocks() const;
  [[nodiscard]] std::size_t n_records(std::size_t block) const;

  /// Uncompressed records of a block. Restarts from the beginning if the block is no longer kept.
  /// Throws IoError naming chunk and point if the stream is damaged or truncated.
  std::vector<std::byte> block(std::size_t index);

 private:
  void restart();
  std::vector<std::byte> decode_next();
  void decode_record(std::byte* record);

  std::span<const std::byte> bytes_;
  LaszipRecord laszip_;
  std::uint64_t n_records_;
  std::uint64_t chunk_size_;
  std::uint32_t block_size_;
  std::string path_;

  std::mutex mutex_;  // guards all members below
  std::size_t next_block_ = 0;
  std::map<std::size_t, std::vector<std::byte>> kept_;
  std::unique_ptr<RecordDecoder> decoder_;
  std::size_t chunk_begin_ = 0;  // byte of bytes_ at which the chunk begins
  std::uint64_t chunk_index_ = 0;
  std::uint64_t place_in_chunk_ = 0;  // index of the next record
};

}  // namespace ridgeline::io::laz
