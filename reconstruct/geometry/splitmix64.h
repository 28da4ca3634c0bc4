// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ridgeline {

/// SplitMix64 (Steele, Lea and Flood 2014, Fast splittable pseudorandom number generators). Unlike
/// the distributions of the standard library, it gives the same numbers with every compiler.
class SplitMix64 {
 public:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15U;

  explicit SplitMix64(std::uint64_t state = 0) : state_(state) {}

  std::uint64_t next() { return mix(state_ += kStep); }

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

 private:
  std::uint64_t state_;
};

}  // namespace ridgeline
