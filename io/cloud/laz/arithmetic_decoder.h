// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/arithmetic_model.h"
#include "io/cloud/laz/byte_stream.h"

#include <cstdint>

namespace ridgeline::io::laz {

/// Range decoder with a 32-bit interval and byte-wise renormalisation (A. Said, HPL-2004-76).
/// Every call throws CodecError at the end of the stream. The offset in the interval stays below
/// the length of the interval for any input, so no damaged stream can lead to a symbol outside its
/// alphabet.
class ArithmeticDecoder {
 public:
  /// Reads the four initial bytes.
  explicit ArithmeticDecoder(ByteStream stream);

  bool decode_bit(BitModel& model) {
    const std::uint32_t split = model.zero_probability() * (length_ >> BitModel::kShift);
    const bool bit = offset_ >= split;
    if (bit) {
      offset_ -= split;
      length_ -= split;
    } else {
      length_ = split;
    }
    if (length_ < kMinLength) renormalise();
    model.count(bit);
    return bit;
  }

  std::uint32_t decode_symbol(SymbolModel& model) {
    model.prepare();
    const std::uint32_t unit = length_ >> SymbolModel::kShift;
    const std::uint32_t code = offset_ / unit;
    auto [symbol, end] = model.candidates(code);
    while (end > symbol + 1) {
      const std::uint32_t middle = (symbol + end) / 2;
      (model.lower(middle) > code ? end : symbol) = middle;
    }
    const std::uint32_t lower = model.lower(symbol) * unit;
    // The last symbol also takes the part of the interval left over by the division.
    const std::uint32_t upper =
        symbol + 1 < model.num_symbols() ? model.lower(symbol + 1) * unit : length_;
    offset_ -= lower;
    length_ = upper - lower;
    if (length_ < kMinLength) renormalise();
    model.count(symbol);
    return symbol;
  }

  /// Reads `num_bits` (1 to 32) bits that were stored without a model.
  std::uint32_t read_bits(unsigned num_bits);
  std::uint32_t read_u32();
  std::uint64_t read_u64();

  /// The stream at its current position. An encoder writes as many bytes as its decoder reads, so
  /// after the last symbol this is the end of the encoder's bytes.
  [[nodiscard]] const ByteStream& stream() const { return stream_; }

 private:
  static constexpr std::uint32_t kMinLength = 1U << 24;

  void renormalise() {
    do {
      offset_ = (offset_ << 8) | stream_.next();
      length_ <<= 8;
    } while (length_ < kMinLength);
  }

  ByteStream stream_;
  std::uint32_t length_ = 0xFFFFFFFFU;
  std::uint32_t offset_ = 0;
};

}  // namespace ridgeline::io::laz
