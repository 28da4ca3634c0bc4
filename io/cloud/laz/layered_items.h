// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/channel_contexts.h"

#include <cstddef>
#include <memory>
#include <span>

namespace ridgeline::io::laz {

using Bytes = std::span<const std::byte>;

/// One part behind the core of a layered record (LASzip compressor 3), for one chunk.
class LayeredItemDecoder {
 public:
  virtual ~LayeredItemDecoder() = default;

  /// Decodes the item of the next record, which belongs to the given scanner channel.
  virtual void decode(unsigned channel, std::byte* item) = 0;
};

/// Each takes the scanner channel and the item of the chunk's first record, which is stored raw,
/// and the item's layers: one for RGB14 and wave packets, two for RGBNIR14 (colour, infrared), one
/// per byte for extra bytes. An empty layer means that the value never changes.
std::unique_ptr<LayeredItemDecoder> make_rgb14_decoder(ItemVersion version,
                                                       unsigned channel,
                                                       Bytes first,
                                                       std::span<const Bytes> layers);
std::unique_ptr<LayeredItemDecoder> make_rgb_nir14_decoder(ItemVersion version,
                                                           unsigned channel,
                                                           Bytes first,
                                                           std::span<const Bytes> layers);
std::unique_ptr<LayeredItemDecoder> make_wave_packet14_decoder(ItemVersion version,
                                                               unsigned channel,
                                                               Bytes first,
                                                               std::span<const Bytes> layers);
std::unique_ptr<LayeredItemDecoder> make_byte14_decoder(ItemVersion version,
                                                        unsigned channel,
                                                        Bytes first,
                                                        std::span<const Bytes> layers);

}  // namespace ridgeline::io::laz
