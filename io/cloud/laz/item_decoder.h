// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/arithmetic_decoder.h"

#include <cstddef>
#include <memory>
#include <span>

namespace ridgeline::io::laz {

/// One part of a point-wise compressed record (LASzip compressors 1 and 2). All parts of a record
/// share one decoder. An object serves one chunk: its models start afresh with the next.
class ItemDecoder {
 public:
  virtual ~ItemDecoder() = default;

  /// Decodes the item of the next record into `item`, which has the size of the item.
  virtual void decode(ArithmeticDecoder& decoder, std::byte* item) = 0;
};

/// Each function makes the decoder of an item from the item of the chunk's first record, which is stored raw. The
/// version is 1 or 2.
std::unique_ptr<ItemDecoder> make_point10_decoder(int version, std::span<const std::byte> first);
std::unique_ptr<ItemDecoder> make_gps_time11_decoder(int version, std::span<const std::byte> first);
std::unique_ptr<ItemDecoder> make_rgb12_decoder(int version, std::span<const std::byte> first);
std::unique_ptr<ItemDecoder> make_byte_decoder(int version, std::span<const std::byte> first);
/// Wave packets exist in version 1 only.
std::unique_ptr<ItemDecoder> make_wave_packet13_decoder(std::span<const std::byte> first);

}  // namespace ridgeline::io::laz
