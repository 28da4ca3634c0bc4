// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/arithmetic_decoder.h"
#include "io/cloud/laz/laszip_record.h"

#include <cstddef>
#include <memory>
#include <span>

namespace ridgeline::io::laz {

/// One part of a point-wise compressed record (LASzip compressors 1 and 2). All parts of a record
/// share one decoder. An object decodes one chunk: the models start afresh with each chunk.
class ItemDecoder {
 public:
  virtual ~ItemDecoder() = default;

  /// Decodes the item of the next record into `item`, which has the size of the item.
  virtual void decode(ArithmeticDecoder& decoder, std::byte* item) = 0;
};

/// The decoder of an item.
/// @param first  the item of the chunk's first record, which is stored raw
std::unique_ptr<ItemDecoder> make_item_decoder(const Item& item, std::span<const std::byte> first);

/// The decoder of POINT10, the core of the record.
/// @param version  1 or 2
std::unique_ptr<ItemDecoder> make_point10_decoder(int version, std::span<const std::byte> first);

}  // namespace ridgeline::io::laz
