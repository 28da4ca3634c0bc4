// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/wave_packet.h"

#include "io/cloud/bytes.h"
#include "io/cloud/laz/wrapping.h"

namespace ridgeline::io::laz {
namespace {

constexpr std::size_t kOffset = 1;
constexpr std::size_t kSize = 9;
constexpr std::size_t kReturnPlace = 13;
constexpr std::size_t kDirection = 17;

}  // namespace

WavePacket WavePacketModels::decode(ArithmeticDecoder& decoder, const WavePacket& last) {
  WavePacket packet;
  packet[0] = static_cast<std::byte>(decoder.decode_symbol(descriptor_));
  store(&packet[kOffset], decode_offset(decoder, last));
  const auto decode_bits = [&](IntegerDecompressor& field, std::size_t at, unsigned context) {
    store(&packet[at], field.decode(decoder, load<std::int32_t>(&last[at]), context));
  };
  decode_bits(size_, kSize, 0);
  decode_bits(return_place_, kReturnPlace, 0);
  for (unsigned axis = 0; axis < 3; ++axis)
    decode_bits(direction_, kDirection + std::size_t{4} * axis, axis);
  return packet;
}

std::uint64_t WavePacketModels::decode_offset(ArithmeticDecoder& decoder, const WavePacket& last) {
  const auto last_offset = load<std::uint64_t>(&last[kOffset]);
  last_offset_kind_ = decoder.decode_symbol(offset_kind_[last_offset_kind_]);
  switch (last_offset_kind_) {
    case 0:
      return last_offset;
    case 1:  // directly after the last packet
      return last_offset + load<std::uint32_t>(&last[kSize]);
    case 2:
      last_offset_step_ = offset_step_.decode(decoder, last_offset_step_);
      return last_offset + static_cast<std::uint64_t>(std::int64_t{last_offset_step_});
    default:
      return decoder.read_u64();
  }
}

}  // namespace ridgeline::io::laz
