// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_header.h"
#include "io/cloud/laz/chunk_table.h"
#include "io/cloud/laz/laszip_record.h"
#include "io/cloud/laz/record_parts.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::io::laz {

class SequentialRecords;

/// The compressed records of a LAZ file as blocks that can be decoded in any order and from any
/// thread. If the file has a chunk table, each block is a chunk. Otherwise (LASzip's compressor 1,
/// or a lost table) blocks are cut from one stream. The stream is decoded once if blocks are
/// requested nearly in order, and again from its start for a block that lies far back.
class LazPoints {
 public:
  /// `file` must outlive the object; `path` is used only in messages.
  /// Throws IoError under the same conditions as read_laszip_record(), and if chunk sizes vary but
  /// no chunk table is usable.
  LazPoints(std::span<const std::byte> file, const LasHeader& header, std::string path);
  ~LazPoints();
  LazPoints(LazPoints&&) noexcept;
  LazPoints& operator=(LazPoints&&) noexcept;

  /// Warnings about what had to be worked around, without the path.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  [[nodiscard]] std::size_t n_blocks() const;
  [[nodiscard]] std::size_t n_points(std::size_t block) const;

  /// The chunks, one per block; empty if blocks are cut from one stream.
  [[nodiscard]] std::span<const Chunk> chunks() const { return chunks_; }

  /// Receives consecutive uncompressed records; `first` is the index of the first one in the block.
  using Consume = std::function<void(std::span<const std::byte> records, std::size_t first)>;

  /// Decodes a block in portions that fit a core's cache.
  /// Throws IoError naming chunk and point if the block is damaged or truncated.
  void decode(std::size_t block, RecordParts parts, const Consume& consume) const;

 private:
  void decode_chunk(std::size_t block, RecordParts parts, const Consume& consume) const;

  std::span<const std::byte> file_;
  std::string path_;
  LaszipRecord laszip_;
  std::vector<std::string> warnings_;
  std::vector<Chunk> chunks_;
  std::unique_ptr<SequentialRecords> sequential_;  // set if blocks are cut from one stream
};

}  // namespace ridgeline::io::laz
