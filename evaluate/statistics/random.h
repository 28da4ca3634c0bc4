// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ridgeline::evaluate {

/// SplitMix64 (Steele, Lea and Flood 2014) keyed by (seed, stream): streams are independent of the
/// order in which threads take them, and unlike the standard library's distributions the numbers
/// are the same with every compiler.
class KeyedRandom {
 public:
  KeyedRandom(std::uint64_t seed, std::uint64_t stream)
      : state_(mix(mix(seed + kStep) ^ (stream * kStep))) {}

  std::uint64_t next() { return mix(state_ += kStep); }

  /// Uniform in [0, n) for 0 < n < 2^32; the bias is below n / 2^32.
  std::uint64_t below(std::uint64_t n) { return ((next() >> 32U) * n) >> 32U; }

 private:
  static constexpr std::uint64_t kStep = 0x9E3779B97F4A7C15U;

  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace ridgeline::evaluate
