// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/arithmetic_decoder.h"

#include "io/cloud/laz/codec_error.h"

namespace ridgeline::io::laz {
namespace {

constexpr unsigned kMaxBitsAtOnce = 19;  // leaves 5 bits of the shortest interval

}  // namespace

ArithmeticDecoder::ArithmeticDecoder(ByteStream stream) : stream_(stream) {
  for (int i = 0; i < 4; ++i) offset_ = (offset_ << 8) | stream_.next();
  if (offset_ >= length_) throw CodecError("the compressed data begin with an impossible code");
}

std::uint32_t ArithmeticDecoder::read_bits(unsigned num_bits) {
  if (num_bits > kMaxBitsAtOnce) {
    const std::uint32_t low = read_bits(16);
    return (read_bits(num_bits - 16) << 16) | low;
  }
  length_ >>= num_bits;
  const std::uint32_t bits = offset_ / length_;
  offset_ -= bits * length_;
  if (length_ < kMinLength) renormalise();
  if ((bits >> num_bits) != 0) throw CodecError("the compressed data hold an impossible code");
  return bits;
}

std::uint32_t ArithmeticDecoder::read_u32() { return read_bits(32); }

std::uint64_t ArithmeticDecoder::read_u64() {
  const std::uint64_t low = read_u32();
  return (std::uint64_t{read_u32()} << 32) | low;
}

}  // namespace ridgeline::io::laz
