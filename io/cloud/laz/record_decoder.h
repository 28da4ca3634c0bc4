// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/laszip_record.h"
#include "io/cloud/laz/record_parts.h"

#include <cstddef>
#include <memory>
#include <span>

namespace ridgeline::io::laz {

/// Decodes the records of one chunk in order.
class RecordDecoder {
 public:
  virtual ~RecordDecoder() = default;

  /// Decodes the next record into `record`, which has LaszipRecord::record_length bytes. The caller
  /// must know how many records the chunk has. Throws CodecError if the chunk is damaged or ends.
  virtual void next(std::byte* record) = 0;

  /// Bytes of the chunk read so far; after its last record, the size of the chunk.
  [[nodiscard]] virtual std::size_t position() const = 0;
};

/// Makes the decoder of the chunk at the beginning of `bytes`, which may extend beyond its end.
/// Parts of a layered record that are not wanted keep the value of the first record of the chunk.
/// Throws CodecError if the chunk ends within its header.
std::unique_ptr<RecordDecoder> make_record_decoder(const LaszipRecord& laszip,
                                                   std::span<const std::byte> bytes,
                                                   RecordParts parts);

}  // namespace ridgeline::io::laz
