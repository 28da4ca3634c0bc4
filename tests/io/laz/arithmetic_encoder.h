// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/arithmetic_model.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ridgeline::io::laz {

/// Counterpart of ArithmeticDecoder, for tests: what it writes the decoder must read back.
class ArithmeticEncoder {
 public:
  void encode_bit(BitModel& model, bool bit);
  void encode_symbol(SymbolModel& model, std::uint32_t symbol);
  void write_bits(unsigned num_bits, std::uint32_t bits);

  /// Ends the stream.
  std::vector<std::byte> finish();

 private:
  void add_to_base(std::uint32_t part);
  void renormalise();

  std::uint32_t base_ = 0;
  std::uint32_t length_ = 0xFFFFFFFFU;
  std::vector<std::uint8_t> bytes_;
};

/// Counterpart of IntegerDecompressor, for tests.
class IntegerCompressor {
 public:
  explicit IntegerCompressor(unsigned num_bits, unsigned num_contexts = 1);
  void encode(ArithmeticEncoder& encoder,
              std::int32_t prediction,
              std::int32_t value,
              unsigned context = 0);

  /// As IntegerDecompressor::last_bit_count().
  [[nodiscard]] unsigned last_bit_count() const { return last_bit_count_; }

 private:
  unsigned num_bits_;
  unsigned last_bit_count_ = 0;
  std::vector<SymbolModel> bit_count_models_;
  std::vector<SymbolModel> high_bits_models_;
  BitModel zero_or_one_model_;
};

}  // namespace ridgeline::io::laz
