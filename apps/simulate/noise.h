// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace ridgeline::simulate {

/// A hash with good mixing, for random values that must be reproducible (lowbias32, Wellons 2018).
inline std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16U)) * 0x7feb352dU;
  x = (x ^ (x >> 15U)) * 0x846ca68bU;
  return x ^ (x >> 16U);
}
inline std::uint32_t hash(std::uint32_t a, std::uint32_t b) {
  return hash(a * 0x9e3779b9U + hash(b));
}
inline std::uint32_t hash(std::int32_t i, std::int32_t k, std::uint32_t key) {
  return hash(static_cast<std::uint32_t>(i), hash(static_cast<std::uint32_t>(k), key));
}

/// Maps a hash to a number uniformly distributed in [0, 1).
inline float unit(std::uint32_t h) { return static_cast<float>(h >> 8U) * 0x1p-24F; }

/// Smooth noise in [-1, 1] with a period of about `wavelength_m`: random values on a grid, cubic
/// blending (value noise).
float value_noise(const Eigen::Vector2f& x_m, float wavelength_m, std::uint32_t key);

/// Sum of value noise whose wavelength is halved from the longest one down, each with half the
/// amplitude of the previous one (`roughness` 0.5). Stops at twice the footprint to avoid aliasing;
/// in [-1, 1].
float fractal_noise(const Eigen::Vector2f& x_m,
                    float longest_m,
                    float shortest_m,
                    float roughness,
                    std::uint32_t key);

}  // namespace ridgeline::simulate
