// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/arithmetic_decoder.h"

#include <cstdint>
#include <vector>

namespace ridgeline::io::laz {

/// Decodes integers as differences from a prediction, modulo 2^bits. A difference is coded as the
/// number k of its bits (a symbol, with one model per context), then its position
/// within [-(2^k - 1), -2^(k-1)] or [2^(k-1) + 1, 2^k], given by up to 8 high bits (a symbol, with
/// one model per k) and raw low bits.
class IntegerDecompressor {
 public:
  /// `num_bits` is 8, 16 or 32.
  explicit IntegerDecompressor(unsigned num_bits, unsigned num_contexts = 1);

  /// The value modulo 2^num_bits, as an unsigned number of that many bits (for 32: the same bits as
  /// a signed number). Throws CodecError at the end of the stream.
  std::int32_t decode(ArithmeticDecoder& decoder, std::int32_t prediction, unsigned context = 0);

  /// The k of the last decoded difference; other fields take their contexts from it.
  unsigned last_bit_count() const { return bit_count_; }

 private:
  std::uint32_t decode_difference(ArithmeticDecoder& decoder);

  std::uint32_t mask_;
  unsigned bit_count_ = 0;
  std::vector<SymbolModel> bit_count_models_;  // one per context
  std::vector<SymbolModel> high_bits_models_;  // one for each k = 1, 2, ...
  BitModel zero_or_one_model_;                 // for k = 0
};

}  // namespace ridgeline::io::laz
