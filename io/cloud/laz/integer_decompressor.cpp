// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/integer_decompressor.h"

#include <algorithm>

namespace ridgeline::io::laz {
namespace {

constexpr unsigned kMaxModelledBits = 8;

}  // namespace

IntegerDecompressor::IntegerDecompressor(unsigned num_bits, unsigned num_contexts)
    : mask_(0xFFFFFFFFU >> (32 - num_bits)),
      bit_count_models_(num_contexts, SymbolModel(num_bits + 1)) {
  for (unsigned k = 1; k <= num_bits; ++k) {
    high_bits_models_.emplace_back(1U << std::min(k, kMaxModelledBits));
  }
}

std::int32_t IntegerDecompressor::decode(ArithmeticDecoder& decoder,
                                         std::int32_t prediction,
                                         unsigned context) {
  bit_count_ = decoder.decode_symbol(bit_count_models_[context]);
  const std::uint32_t value = static_cast<std::uint32_t>(prediction) + decode_difference(decoder);
  return static_cast<std::int32_t>(value & mask_);
}

std::uint32_t IntegerDecompressor::decode_difference(ArithmeticDecoder& decoder) {
  const unsigned k = bit_count_;
  if (k == 0) return decoder.decode_bit(zero_or_one_model_) ? 1 : 0;
  if (k == 32) return 0x80000000U;  // the smallest number is coded without further bits

  std::uint32_t place = decoder.decode_symbol(high_bits_models_[k - 1]);
  if (k > kMaxModelledBits) {
    const unsigned num_low_bits = k - kMaxModelledBits;
    place = (place << num_low_bits) | decoder.read_bits(num_low_bits);
  }
  const bool positive = place >= (1U << (k - 1));
  return positive ? place + 1 : place - ((1U << k) - 1);
}

}  // namespace ridgeline::io::laz
