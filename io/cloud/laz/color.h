// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/laz/arithmetic_decoder.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ridgeline::io::laz {

using Rgb = std::array<std::uint16_t, 3>;

/// Models of red, green and blue (RGB12 version 2; RGB14 and RGBNIR14 of versions 3 and 4).
class RgbModels {
 public:
  /// Green is predicted from the change of red, blue from the mean change of red and green.
  Rgb decode(ArithmeticDecoder& decoder, const Rgb& last);

 private:
  SymbolModel changed_{128};
  std::vector<SymbolModel> differences_{6, SymbolModel(256)};  // low, high byte of R, of G, of B
};

/// Models of the near infrared (RGBNIR14).
class NirModels {
 public:
  std::uint16_t decode(ArithmeticDecoder& decoder, std::uint16_t last);

 private:
  SymbolModel changed_{4};
  std::vector<SymbolModel> differences_{2, SymbolModel(256)};
};

}  // namespace ridgeline::io::laz
