// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/laszip_record.h"

#include <cstddef>
#include <memory>
#include <span>

namespace ridgeline::io::laz {

using Bytes = std::span<const std::byte>;

/// Decodes one part after the core of a layered record (LASzip compressor 3), for one chunk.
class LayeredItemDecoder {
 public:
  virtual ~LayeredItemDecoder() = default;

  /// Decodes the item of the next record, which belongs to the given scanner channel.
  virtual void decode(unsigned channel, std::byte* item) = 0;
};

/// The decoder of an item that is not the core of the record.
/// @param channel  scanner channel of the chunk's first record
/// @param first    the item of that record, which is stored raw
/// @param layers   layers of the item: one for RGB14 and wave packets, two for RGBNIR14
///                 (colour, infrared), one per byte for extra bytes. An empty layer means that
///                 the value never changes.
std::unique_ptr<LayeredItemDecoder> make_layered_item_decoder(const Item& item,
                                                              unsigned channel,
                                                              Bytes first,
                                                              std::span<const Bytes> layers);

}  // namespace ridgeline::io::laz
