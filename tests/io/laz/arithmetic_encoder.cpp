// SPDX-License-Identifier: BSD-3-Clause
#include "tests/io/laz/arithmetic_encoder.h"

#include <algorithm>
#include <bit>

namespace ridgeline::io::laz {

void ArithmeticEncoder::add_to_base(std::uint32_t part) {
  base_ += part;
  if (base_ >= part) return;
  // The sum ran over: carry into the bytes already written.
  auto byte = bytes_.rbegin();
  while (*byte == 0xFF) *byte++ = 0;
  ++*byte;
}

void ArithmeticEncoder::renormalise() {
  while (length_ < (1U << 24)) {
    bytes_.push_back(static_cast<std::uint8_t>(base_ >> 24));
    base_ <<= 8;
    length_ <<= 8;
  }
}

void ArithmeticEncoder::encode_bit(BitModel& model, bool bit) {
  const std::uint32_t split = model.zero_probability() * (length_ >> BitModel::kShift);
  if (bit) {
    add_to_base(split);
    length_ -= split;
  } else {
    length_ = split;
  }
  renormalise();
  model.count(bit);
}

void ArithmeticEncoder::encode_symbol(SymbolModel& model, std::uint32_t symbol) {
  model.prepare();
  const std::uint32_t unit = length_ >> SymbolModel::kShift;
  const std::uint32_t lower = model.lower(symbol) * unit;
  const bool is_last = symbol + 1 == model.num_symbols();
  const std::uint32_t upper = is_last ? length_ : model.lower(symbol + 1) * unit;
  add_to_base(lower);
  length_ = upper - lower;
  renormalise();
  model.count(symbol);
}

void ArithmeticEncoder::write_bits(unsigned num_bits, std::uint32_t bits) {
  if (num_bits > 19) {
    write_bits(16, bits & 0xFFFFU);
    write_bits(num_bits - 16, bits >> 16);
    return;
  }
  length_ >>= num_bits;
  add_to_base(bits * length_);
  renormalise();
}

std::vector<std::byte> ArithmeticEncoder::finish() {
  // The middle of the interval lies inside it whatever the decoder reads behind these bytes.
  add_to_base(length_ / 2);
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes_.push_back(static_cast<std::uint8_t>(base_ >> shift));
  }
  std::vector<std::byte> result(bytes_.size());
  std::ranges::transform(bytes_, result.begin(), [](std::uint8_t byte) { return std::byte{byte}; });
  return result;
}

IntegerCompressor::IntegerCompressor(unsigned num_bits, unsigned num_contexts)
    : num_bits_(num_bits), bit_count_models_(num_contexts, SymbolModel(num_bits + 1)) {
  for (unsigned k = 1; k <= num_bits; ++k) high_bits_models_.emplace_back(1U << std::min(k, 8U));
}

void IntegerCompressor::encode(ArithmeticEncoder& encoder,
                               std::int32_t prediction,
                               std::int32_t value,
                               unsigned context) {
  // The difference modulo 2^bits, as the number of least magnitude.
  const unsigned unused_bits = 32 - num_bits_;
  const std::uint32_t wrapped =
      (static_cast<std::uint32_t>(value) - static_cast<std::uint32_t>(prediction)) << unused_bits;
  const std::int64_t difference = static_cast<std::int32_t>(wrapped) >> unused_bits;
  const std::int64_t magnitude = difference <= 0 ? -difference : difference - 1;
  const auto k = static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(magnitude)));
  last_bit_count_ = k;
  encoder.encode_symbol(bit_count_models_[context], k);
  if (k == 0) {
    encoder.encode_bit(zero_or_one_model_, difference == 1);
  } else if (k < 32) {
    const std::int64_t place =
        difference < 0 ? difference + (std::int64_t{1} << k) - 1 : difference - 1;
    const unsigned low_bits = k > 8 ? k - 8 : 0;
    encoder.encode_symbol(high_bits_models_[k - 1], static_cast<std::uint32_t>(place >> low_bits));
    if (low_bits > 0) {
      encoder.write_bits(low_bits, static_cast<std::uint32_t>(place) & ((1U << low_bits) - 1));
    }
  }
}

}  // namespace ridgeline::io::laz
