// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/integer_decompressor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ridgeline::io::laz {

/// The 29 bytes of a wave packet record: u8 descriptor, u64 offset, u32 size, then four f32
/// (position of the return, direction x, y, z), which are coded as their bit patterns.
using WavePacket = std::array<std::byte, 29>;

/// Models of wave packets (WAVEPACKET13 version 1; WAVEPACKET14 of versions 3 and 4).
class WavePacketModels {
 public:
  WavePacket decode(ArithmeticDecoder& decoder, const WavePacket& last);

 private:
  std::uint64_t decode_offset(ArithmeticDecoder& decoder, const WavePacket& last);

  SymbolModel descriptor_{256};
  std::vector<SymbolModel> offset_kind_{4, SymbolModel(4)};  // one model for each previous kind
  IntegerDecompressor offset_step_{32};
  IntegerDecompressor size_{32};
  IntegerDecompressor return_place_{32};
  IntegerDecompressor direction_{32, 3};
  std::uint32_t last_offset_kind_ = 0;
  std::int32_t last_offset_step_ = 0;
};

}  // namespace ridgeline::io::laz
