// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/noise.h"

#include <cmath>

namespace ridgeline::other {
namespace {

/// The finaliser of SplitMix64 (Steele et al. 2014).
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31U);
}

double smooth(double t) { return t * t * (3.0 - 2.0 * t); }

}  // namespace

double cell_noise(std::int64_t column, std::int64_t row, std::uint64_t seed) {
  const std::uint64_t key =
      mixed(static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15ULL + seed);
  return static_cast<double>(mixed(key + static_cast<std::uint64_t>(row) * 0xC2B2AE3D27D4EB4FULL) >>
                             11U) *
         0x1.0p-53;
}

double value_noise(double x, double y, std::uint64_t seed) {
  const double column = std::floor(x);
  const double row = std::floor(y);
  const auto c = static_cast<std::int64_t>(column);
  const auto r = static_cast<std::int64_t>(row);
  const double s = smooth(x - column);
  const double t = smooth(y - row);
  const double near = (1.0 - s) * cell_noise(c, r, seed) + s * cell_noise(c + 1, r, seed);
  const double far = (1.0 - s) * cell_noise(c, r + 1, seed) + s * cell_noise(c + 1, r + 1, seed);
  return (1.0 - t) * near + t * far;
}

double fractal_noise(double x, double y, int octaves, std::uint64_t seed) {
  double sum = 0.0;
  double weight = 0.5;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * (2.0 * value_noise(x, y, seed + static_cast<std::uint64_t>(octave)) - 1.0);
    x *= 2.0;
    y *= 2.0;
    weight *= 0.5;
  }
  return sum;
}

}  // namespace ridgeline::other
