// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/color.h"

#include <algorithm>

namespace ridgeline::io::laz {
namespace {

int byte_of(std::uint16_t value, unsigned shift) { return (value >> shift) & 0xFF; }

std::uint16_t wrapped(std::uint32_t byte, unsigned shift) {
  return static_cast<std::uint16_t>((byte & 0xFFU) << shift);
}

}  // namespace

Rgb RgbModels::decode(ArithmeticDecoder& decoder, const Rgb& last) {
  constexpr std::uint32_t kNotGrey = 1U << 6;
  const std::uint32_t changed = decoder.decode_symbol(changed_);
  Rgb rgb{};
  // Decodes a byte of a channel as a difference from its prediction. A byte that is not marked as
  // changed keeps its value.
  const auto decode_byte = [&](unsigned channel, unsigned shift, int shift_of_prediction) {
    const unsigned byte = 2 * channel + (shift == 0 ? 0 : 1);
    const int previous = byte_of(last[channel], shift);
    if ((changed & (1U << byte)) == 0) {
      rgb[channel] |= wrapped(static_cast<std::uint32_t>(previous), shift);
      return;
    }
    const int prediction = std::clamp(previous + shift_of_prediction, 0, 255);
    const std::uint32_t difference = decoder.decode_symbol(differences_[byte]);
    rgb[channel] |= wrapped(static_cast<std::uint32_t>(prediction) + difference, shift);
  };
  decode_byte(0, 0, 0);
  decode_byte(0, 8, 0);
  if ((changed & kNotGrey) == 0) return {rgb[0], rgb[0], rgb[0]};
  for (const unsigned shift : {0U, 8U}) {
    const int red_change = byte_of(rgb[0], shift) - byte_of(last[0], shift);
    decode_byte(1, shift, red_change);
    const int green_change = byte_of(rgb[1], shift) - byte_of(last[1], shift);
    decode_byte(2, shift, (red_change + green_change) / 2);
  }
  return rgb;
}

std::uint16_t NirModels::decode(ArithmeticDecoder& decoder, std::uint16_t last) {
  const std::uint32_t changed = decoder.decode_symbol(changed_);
  std::uint16_t nir = 0;
  for (const unsigned byte : {0U, 1U}) {
    auto value = static_cast<std::uint32_t>(byte_of(last, 8 * byte));
    if ((changed & (1U << byte)) != 0) value += decoder.decode_symbol(differences_[byte]);
    nir |= wrapped(value, 8 * byte);
  }
  return nir;
}

}  // namespace ridgeline::io::laz
