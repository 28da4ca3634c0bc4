// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/noise.h"

namespace ridgeline::simulate {
namespace {

/// Inline replacement for std::floor, which is a function call without SSE 4.1.
std::int32_t floor_of(float x) {
  const auto truncated = static_cast<std::int32_t>(x);
  return truncated - (static_cast<float>(truncated) > x ? 1 : 0);
}

}  // namespace

float value_noise(const Eigen::Vector2f& x_m, float wavelength_m, std::uint32_t key) {
  const float x = x_m.x() / wavelength_m;
  const float y = x_m.y() / wavelength_m;
  const std::int32_t i = floor_of(x);
  const std::int32_t k = floor_of(y);
  const auto blend = [](float t) { return t * t * (3.0F - 2.0F * t); };
  const float s = blend(x - static_cast<float>(i));
  const float t = blend(y - static_cast<float>(k));
  const auto at = [&](std::int32_t di, std::int32_t dk) {
    return 2.0F * unit(hash(i + di, k + dk, key)) - 1.0F;
  };
  const float low = at(0, 0) + s * (at(1, 0) - at(0, 0));
  const float high = at(0, 1) + s * (at(1, 1) - at(0, 1));
  return low + t * (high - low);
}

float fractal_noise(const Eigen::Vector2f& x_m,
                    float longest_m,
                    float shortest_m,
                    float roughness,
                    std::uint32_t key) {
  float sum = 0.0F;
  float weight = 1.0F;
  float total = 0.0F;
  float wavelength_m = longest_m;
  while (wavelength_m >= shortest_m) {
    sum += weight * value_noise(x_m, wavelength_m, ++key);
    wavelength_m *= 0.5F;
    total += weight;
    weight *= roughness;
  }
  return total > 0.0F ? sum / total : 0.0F;
}

}  // namespace ridgeline::simulate
