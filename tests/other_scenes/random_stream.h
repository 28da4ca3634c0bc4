// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace ridgeline::other {

/// Random numbers that are the same on every platform: the distributions of the standard library
/// are not.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15ULL + 77U) {}

  std::uint64_t bits() { return engine_(); }
  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// One of 0 .. n - 1.
  int index(int n) { return static_cast<int>(uniform() * n); }
  bool chance(double probability) { return uniform() < probability; }
  /// Normal with mean 0 (Box and Muller 1958).
  double normal(double sigma) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return sigma * radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace ridgeline::other
